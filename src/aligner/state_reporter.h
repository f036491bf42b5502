// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "announcer.h"
#include "goal_alignment/AlignGoal.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Question.h"
#include "goal_alignment/session/session.h"
#include "goal_ticket.h"
#include "question_bridge.h"
#include "session_record.h"

namespace goal_alignment::aligner {

/// Reports on the session under way: ~state, the action's feedback, and events for people. Belongs
/// to the solver thread.
class StateReporter {
 public:
  /// All outlive this.
  StateReporter(const SessionRecord& current, Announcer& announcer, QuestionBridge& bridge);

  /// Another session has begun: nothing was reported about it yet.
  void beginSession() { reported_plan_break_.clear(); }
  /// Tells people which task has begun, or that a session continues.
  void announceGoal(const AlignGoal& goal);
  /// Predicates of assumed_wanted_predicates and assumed_unwanted_predicates that no candidate has
  /// may be misspelled.
  void warnAboutUnmatchedHidden();

  /// `open` is the open question; question_id 0: none.
  void report(GoalTicket& ticket, const session::Snapshot& now, const std::string& message,
              const Question& open);
  /// The last report says that a question is open.
  bool showsOpenQuestion() const { return shows_open_question_; }

  /// Of the session, with where the human's plan fails as last reported; no outcome.
  AlignmentState stateMessage(const session::Snapshot& now, const std::string& message) const;

 private:
  std::string taskText(const HumanTask& task) const;
  void warnIfUnmatched(const std::string& predicate, const session::Snapshot& now);
  void reportPlanBreak();

  const SessionRecord& current_;
  Announcer& announcer_;
  QuestionBridge& bridge_;
  std::string reported_plan_break_;
  bool shows_open_question_ = false;
};

}  // namespace goal_alignment::aligner
