// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "goal_alignment/ExecutePlanAction.h"
#include "goal_alignment/any_message/message_definition.h"
#include "goal_alignment/any_message/service_caller.h"
#include "goal_alignment/any_message/wait_point.h"
#include "goal_alignment/execution/aligner_link.h"
#include "goal_alignment/execution/dispatch_listeners.h"
#include "goal_alignment/execution/executor_diagnostics.h"
#include "goal_alignment/execution/executor_options.h"
#include "goal_alignment/execution/facts_ledger.h"
#include "goal_alignment/execution/plan_run.h"
#include "goal_alignment/execution/step_mapping.h"
#include "goal_alignment/execution/steps.h"
#include "goal_alignment/ros_common/action_server.h"

namespace goal_alignment::execution {

/// Offers `execute_plan`: dispatches every step on `action_dispatch`, carries it out as the mapping
/// says, and reports it on `action_feedback`. A newer plan displaces the one that runs, once its
/// step has stopped.
class PlanExecutor {
 public:
  /// `default_kind`: how actions are carried out of which no mapping says anything.
  PlanExecutor(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
               std::optional<StepKind> default_kind);
  ~PlanExecutor();
  PlanExecutor(const PlanExecutor&) = delete;
  PlanExecutor& operator=(const PlanExecutor&) = delete;

  /// Takes a plan that came another way than as an action; `origin` begins its goal's id.
  void submit(const Plan& plan, const std::string& origin);

  /// The node is about to end: stops the step under way, cancels the goals there are and those to
  /// come, and returns when they have their results. The destructor does it as well.
  void endGoals();

 private:
  using Server = ros_common::ActionServer<ExecutePlanAction>;
  using Goal = Server::GoalHandle;

  void takeGoal(Goal goal);
  void cancelGoal(const Goal& goal);
  void work();
  void beIdle();
  void run(Goal goal);
  void conclude(Goal goal, ExecutePlanResult result);
  static void log(const ExecutePlanResult& result);
  void interrupt(const std::string& why);  // needs mutex_
  StepMapping mappingOf(const ExecutorOptions& options);
  void complainAtTheStart();
  void warnAboutUnknown(const ExecutorOptions& options);
  void warnAboutMisfits(const ExecutorOptions& options);
  void warnAboutServers();
  void warnOnce(const std::string& what);
  void follow(const Plan& plan, const ExecutePlanFeedback& feedback);

  ros::NodeHandle private_node_;
  std::optional<StepKind> default_kind_;
  DispatchListeners listeners_;
  ros::Publisher dispatches_;
  ros::Publisher feedback_;
  any_message::WaitPoint wait_;

  // Of the worker thread alone, once it runs.
  any_message::MessageTypes types_{any_message::installedDefinition};
  any_message::ServiceCaller services_;
  AlignerLink aligner_;
  FactsLedger ledger_{aligner_};
  ActionSteps action_steps_;
  ServiceSteps service_steps_;
  DispatchedSteps dispatched_steps_;
  SimulatedSteps simulated_steps_;
  std::set<std::string> warned_about_;
  StepMapping first_mapping_;  // of the start, until its servers were looked for
  any_message::Clock::time_point look_for_servers_ = any_message::Clock::time_point::max();
  ExecutorDiagnostics diagnostics_;

  std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::optional<Goal> next_;
  std::optional<Goal> current_;
  std::string why_stopped_;  // the current plan
  bool stop_ = false;        // the program ends
  unsigned submitted_ = 0;

  Server server_;
  std::thread worker_;
};

}  // namespace goal_alignment::execution
