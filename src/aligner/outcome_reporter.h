// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "announcer.h"
#include "explanation_feed.h"
#include "goal_alignment/AlignResult.h"
#include "goal_alignment/session/outcome.h"
#include "goal_alignment/session/session.h"
#include "goal_ticket.h"
#include "journal.h"
#include "plan_watch.h"
#include "question_bridge.h"
#include "session_answers.h"
#include "session_record.h"
#include "state_reporter.h"

namespace goal_alignment::aligner {

/// How a goal ends: publishes its outcome and plan, and settles what the journal keeps. Belongs to
/// the solver thread.
class OutcomeReporter {
 public:
  /// What is published to, and kept, besides the session's own parts. All outlive the reporter.
  struct Sinks {
    Announcer& announcer;
    QuestionBridge& bridge;
    Journal& journal;
    PlanWatch& plan_watch;
  };

  OutcomeReporter(const SessionRecord& current, const Sinks& sinks, SessionAnswers& answers,
                  StateReporter& states, ExplanationFeed& explanations);

  /// Publishes the outcome on all topics and returns the result for the client, who gets it last.
  /// `instead` replaces the session's own words, unless it is empty.
  AlignResult announce(const session::Outcome& outcome, const std::string& instead);

  /// Ends a goal that could not begin or was aborted.
  void refuse(GoalTicket& ticket, const session::Outcome& outcome);
  /// Ends a goal that was claimed for it.
  void endWith(GoalTicket& ticket, const session::Outcome& outcome);

 private:
  AlignResult resultOf(const session::Outcome& outcome, const session::Snapshot& last,
                       const std::string& instead) const;
  void publishPlan(AlignResult& result);
  void settleJournal(session::OutcomeCode code);
  void publishState(const session::Snapshot& last, const AlignResult& result);

  const SessionRecord& current_;
  const Sinks sinks_;
  SessionAnswers& answers_;
  StateReporter& states_;
  ExplanationFeed& explanations_;
  std::int32_t plans_ = 0;  // published so far
};

}  // namespace goal_alignment::aligner
