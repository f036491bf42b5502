// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/any_message/arguments.h"
#include "goal_alignment/any_message/message_definition.h"
#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::execution {

/// How a step of a plan is carried out.
enum class StepKind {
  Action,    ///< a goal for an actionlib server
  Service,   ///< a service call
  Dispatch,  ///< ROSPlan's way: somebody hears action_dispatch and answers on action_feedback
  Simulated  ///< time passes, frames move
};

/// A frame that a simulated step moves, or gives another parent. Texts with braces, see Arguments.
struct FrameMove {
  YAML::Node frame;
  YAML::Node parent;  ///< null: it keeps its own
  YAML::Node to;      ///< the pose in its parent at the end; null: it stays where it is
};

/// What the mapping says of a PDDL action.
struct StepRule {
  static constexpr int kAlways = -1;

  StepKind kind = StepKind::Dispatch;
  YAML::Node key;     ///< the action, as the file names it; of `default` null
  YAML::Node name;    ///< of the action's server or the service; text with braces
  YAML::Node fields;  ///< of the goal or the request
  std::optional<any_message::ActionDefinition> action;    ///< of StepKind::Action
  std::optional<any_message::ServiceDefinition> service;  ///< of StepKind::Service
  /// Fields of the result or the response, and what each must be for the step to have succeeded.
  std::vector<std::pair<std::string, YAML::Node>> success;

  double timeout = 300;        ///< seconds for one try, 0 … 86400; 0: for ever
  int retries = 0;             ///< further tries after a failure, 0 … 1000
  double server_timeout = 10;  ///< seconds, 0 … 86400, until the server must be there, or is lost
  bool stop_on_failure = false;               ///< no new plan is asked for
  std::vector<YAML::Node> failure_facts;      ///< literals: what the robot knows when it failed
  std::optional<double> duration;             ///< seconds that it takes, 0 … 3600
  std::optional<double> failure_probability;  ///< simulated: 0 … 1
  std::vector<FrameMove> moves;               ///< simulated
};

/// Where a simulated frame is at first. The pose in the node is `[x, y, yaw]`, `[x, y, z, yaw]`
/// (metres, radians) or has the fields of geometry_msgs/Pose.
struct InitialFrame {
  std::string name;
  std::string parent;
  YAML::Node pose;
};

/// How the actions of a domain are carried out: config/execution.yaml explains the format.
struct StepMapping {
  std::string source;  ///< the file's name, for errors
  YAML::Node tables;
  std::map<std::string, StepRule> rules;  ///< by action, lower case
  std::optional<StepRule> fallback;       ///< of actions that have none
  std::vector<InitialFrame> frames;
  std::vector<std::string> warnings;   ///< of keys under their former names, a sentence each
  std::map<GroundName, int> failures;  ///< simulated: how many tries fail, or StepRule::kAlways

  /// Null: nothing is said of it.
  const StepRule* find(const std::string& action) const;

  /// Throws YamlError at the first fault. `default_kind`, if given, is that of every action of
  /// which nothing else is said. An empty text is an empty mapping.
  static StepMapping fromYaml(const std::string& text, const std::string& source,
                              any_message::MessageTypes& types,
                              std::optional<StepKind> default_kind);
};

}  // namespace goal_alignment::execution
