// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <optional>

#include "goal_alignment/execution/auto_execution.h"
#include "goal_alignment/execution/plan_executor.h"
#include "goal_alignment/ros_interface/graceful_end.h"

namespace goal_alignment::nodes {

/// What plan_executor and simulated_executor share: all but what happens to an action of which no
/// mapping speaks.
inline void runExecutor(int argc, char** argv, const char* default_name,
                        std::optional<execution::StepKind> default_kind) {
  using namespace ros_interface;  // NOLINT(google-build-using-namespace)
  initWithLastWords(argc, argv, default_name);
  const ros::NodeHandle node;
  const ros::NodeHandle private_node("~");
  const auto options = execution::ExecutorOptions::atTheStart(private_node);
  execution::PlanExecutor executor(node, private_node, default_kind);
  std::optional<execution::AutoExecution> automatic;
  if (options.auto_execute) {
    automatic.emplace(node, options.aligner,
                      [&executor](const Plan& plan) { executor.submit(plan, "auto_execute"); });
  }
  // Goals, cancels, what servers say and frames each find a thread.
  ros::AsyncSpinner spinner(4);
  spinner.start();
  waitUntilToldToEnd();
  executor.endGoals();
  flushPublished();
  spinner.stop();
  ros::shutdown();
}

}  // namespace goal_alignment::nodes
