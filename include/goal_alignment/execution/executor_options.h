// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "goal_alignment/any_message/time_limit.h"

namespace goal_alignment::execution {

/// Parameters of plan_executor and simulated_executor, read anew for every plan.
/// config/plan_executor.yaml lists them in this order.
struct ExecutorOptions {
  std::string mapping;  ///< file, absolute or relative to the package's folder; "": none
  std::string aligner = "goal_alignment";  ///< name of its node; read at the start alone
  bool auto_execute = false;               ///< read at the start alone
  bool watch = true;                       ///< check preconditions, tell effects, ask for new plans
  std::string robot_domain;                ///< "": those of the aligner's parameters
  std::string robot_problem;
  double facts_timeout = 2;  ///< seconds, 0 … 3600, for which a condition may be false or unknown
  int max_replans = 3;       ///< 0 … 1000 for a goal
  double cancel_timeout = 5;  ///< seconds, 0 … 3600, that a cancelled step may take to stop
  any_message::ClockKind clock =
      any_message::ClockKind::Wall;  ///< of time-outs and durations of steps
  double diagnostic_period = 1;  ///< seconds of wall time, 0.01 … 3600; read at the start alone
  double servers_timeout = 3;  ///< seconds, 0 … 3600, for which all that steps need may be missing

  // Of simulated steps.
  double step_duration = 0.5;      ///< seconds, 0 … 3600, of steps whose rule says nothing
  double failure_probability = 0;  ///< 0 … 1 for each try of such a step
  int failing_step = -1;           ///< index of the plan's step that fails; -1: none
  int seed = 0;                    ///< 0 … 2^31-1; the same seed, the same failures
  double frame_rate = 20;          ///< Hz, 1 … 200, at which frames are broadcast

  std::vector<std::string> warnings;  ///< unknown and renamed parameters, a sentence each

  /// Both throw ros_common::ParameterError, which names key and namespace.
  static ExecutorOptions read(const ros::NodeHandle& private_node);
  static ExecutorOptions read(const XmlRpc::XmlRpcValue& values, const std::string& ns);

  /// What is read at the start alone; a fault anywhere leaves the defaults of everything else.
  static ExecutorOptions atTheStart(const ros::NodeHandle& private_node);
};

}  // namespace goal_alignment::execution
