// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/action_server.h>
#include <ros/ros.h>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "goal_alignment/ExecutePlanAction.h"

namespace goal_alignment::execution {

/// Parameters of a simulated execution, read anew for every plan.
struct SimulationOptions {
  double step_duration = 0.5;  ///< seconds a step takes, 0 … 3600
  int failing_step = -1;       ///< index of the step that fails; -1: none does

  /// Throws std::invalid_argument that names key and namespace.
  static SimulationOptions read(const ros::NodeHandle& private_node);
};

/// Why a plan can't be run as it stands; empty: it can.
std::string faultOf(const Plan& plan);

/// Offers `execute_plan` where there is no robot: walks through the plan, one step per
/// `~step_duration`, dispatches every step on `action_dispatch` and reports it on
/// `action_feedback`. A newer plan displaces the one that runs.
class SimulatedExecutor {
 public:
  SimulatedExecutor(ros::NodeHandle node, ros::NodeHandle private_node);
  ~SimulatedExecutor();

 private:
  using Server = actionlib::ActionServer<ExecutePlanAction>;
  using Goal = Server::GoalHandle;

  void takeGoal(Goal goal);
  void cancelGoal(Goal goal);
  void work();
  void run(Goal goal);
  ExecutePlanResult walk(Goal& goal, const SimulationOptions& options);
  void dispatch(const ActionDispatch& step, float seconds_since_start, float duration);
  void report(Goal& goal, const ActionDispatch& step, int status);
  bool interruptedWithin(double seconds);

  ros::NodeHandle private_node_;
  ros::Publisher dispatches_;
  ros::Publisher feedback_;

  std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::optional<Goal> next_;
  std::optional<Goal> current_;
  bool interrupt_ = false;  // the current plan is to stop
  bool stop_ = false;       // the program ends

  Server server_;
  std::thread worker_;
};

}  // namespace goal_alignment::execution
