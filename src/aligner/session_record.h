// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "goal_alignment/AlignResult.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/session/session.h"
#include "journal.h"
#include "node_options.h"

namespace goal_alignment::aligner {

/// What a session is called, and for whom it is.
struct SessionLabels {
  std::string id;
  std::string person;
  std::string task_id;
  std::string goal_identity;  ///< of the goal that began it, as GoalTicket has it
};

/// What the goal under way has used so far. The session counts across all of its goals, so what
/// the earlier ones used is subtracted.
struct GoalUsage {
  double waiting_time = 0;      ///< seconds, of the goal under way
  double earlier_thinking = 0;  ///< seconds
  std::size_t earlier_calls = 0;
  std::size_t earlier_questions = 0;
};

/// A session and what the node knows about it, across the goals that continue it. Belongs to the
/// solver thread.
struct SessionRecord {
  SessionLabels labels;
  std::shared_ptr<session::Session> session;  ///< null: no task yet
  std::vector<GroundName> human_plan;
  phrasing::Phrases phrases;
  NodeOptions options;  ///< as read for the goal under way
  ros_common::AnswerTimes answer_times;
  std::vector<JournalAnswer> journaled;  ///< on record, but not passed to the session yet
  GoalUsage usage;
  bool models_loaded = false;
  unsigned timeouts = 0;  ///< of the open question, since anybody last answered

  /// Another goal continues the session: its usage is counted from here.
  void beginNextGoal();
  /// Seconds that the goal under way has taken to think.
  double thinkingTime() const;

  std::string clausesOf(const std::vector<Literal>& fluents) const;
  /// Where the human's plan first fails for the robot, as one sentence; empty: it doesn't, or that
  /// is not known yet.
  std::string planBreak() const;

  /// No outcome and no message yet.
  AlignmentState stateMessage(const session::Snapshot& now) const;
  /// Candidates, questions, calls and times of the goal under way; no outcome.
  AlignResult usageResult(const session::Snapshot& now) const;
};

}  // namespace goal_alignment::aligner
