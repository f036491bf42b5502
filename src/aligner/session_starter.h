// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <set>
#include <string>

#include "announcer.h"
#include "goal_alignment/AlignGoal.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/session/outcome.h"
#include "goal_alignment/session/session.h"
#include "journal.h"
#include "node_options.h"
#include "question_bridge.h"
#include "robot_facts.h"
#include "session_answers.h"
#include "session_record.h"
#include "tf_state_bridge.h"

namespace goal_alignment::aligner {

/// Reads parameters and goals, and makes sessions of them. Belongs to the solver thread.
class SessionStarter {
 public:
  /// What a new session is introduced to. All outlive the starter.
  struct Targets {
    Announcer& announcer;
    QuestionBridge& bridge;
    Journal& journal;
    RobotFacts& facts;
    TfStateBridge& tf;
  };

  SessionStarter(ros::NodeHandle private_node, const Targets& targets, SessionRecord& current,
                 SessionAnswers& answers);

  /// Makes the goal's session the current one, or continues it. Returns the outcome of a goal that
  /// can't be accepted; the current session then stays.
  std::optional<session::Outcome> start(const AlignGoal& goal);

 private:
  void prepare(const AlignGoal& goal);
  void begin(const AlignGoal& goal, const NodeOptions& options);
  void continueSession(const AlignGoal& goal, const NodeOptions& options);
  void inheritFacts(const NodeOptions& options, session::Input& input);
  phrasing::Phrases readPhrases(const NodeOptions& options);
  void warnAboutParameters(const NodeOptions& options);

  const ros::NodeHandle private_node_;
  const Targets targets_;
  SessionRecord& current_;
  SessionAnswers& answers_;
  std::set<std::string> reported_parameters_;
};

}  // namespace goal_alignment::aligner
