// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <set>
#include <string>

#include "goal_alignment/AskHuman.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/dialogues/dialogue_diagnostics.h"
#include "goal_alignment/dialogues/question_watch.h"

namespace goal_alignment::dialogues {

/// The fluents that a scripted person wants.
using TrueGoal = std::set<Literal>;

/// Reads a list of texts `(on a b)`, or a file name: `.yaml` and `.yml` hold a list, alone or under
/// the key `true_goal`; any other file one fluent a line. Throws std::runtime_error or
/// std::invalid_argument that says where the fault is.
TrueGoal readTrueGoal(const XmlRpc::XmlRpcValue& parameter);

/// YES for the question's fluents in the true goal, NO for the others.
AskHuman::Response answerFor(const Question& question, const TrueGoal& true_goal);

/// Answers `ask_human` from a true goal, after `~delay` seconds (default 0).
class ScriptedDialogue {
 public:
  /// Throws what readTrueGoal() throws, and std::invalid_argument for a wrong parameter.
  ScriptedDialogue(ros::NodeHandle node, const ros::NodeHandle& private_node);

 private:
  bool ask(AskHuman::Request& request, AskHuman::Response& response);

  TrueGoal true_goal_;
  double delay_ = 0;
  QuestionWatch watch_;
  DialogueDiagnostics diagnostics_;
  ros::ServiceServer service_;
};

}  // namespace goal_alignment::dialogues
