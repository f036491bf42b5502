// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <cstdlib>
#include <functional>
#include <optional>
#include <string>

#include "goal_alignment/execution/auto_execution.h"
#include "goal_alignment/execution/graph_view.h"
#include "goal_alignment/execution/names.h"
#include "goal_alignment/execution/plan_executor.h"
#include "goal_alignment/ros_common/deferred_shutdown.h"

namespace goal_alignment::nodes {

/// Whether another node, one that counts, offers execute_plan by the same name: both would take
/// every goal. Says so.
inline bool isTaken(const ros::NodeHandle& node,
                    const std::function<bool(const std::string&)>& counts) {
  const std::string action = node.resolveName(execution::kExecutePlanAction);
  const auto other = execution::otherPublisher(action + "/status");
  if (!other || !counts(*other)) return false;
  ROS_ERROR(
      "%s offers %s already, and both would carry out every plan: this one does not start. "
      "Another robot's executor belongs into a namespace of its own",
      other->c_str(), action.c_str());
  ros_common::flushPublished();
  return true;
}

/// What plan_executor and simulated_executor share: all but what happens to an action of which no
/// mapping speaks. Returns the exit status.
inline int runExecutor(int argc, char** argv, const char* default_name,
                       std::optional<execution::StepKind> default_kind) {
  ros_common::initWithDeferredShutdown(argc, argv, default_name);
  const ros::NodeHandle node;
  const ros::NodeHandle private_node("~");
  const std::string name = ros::this_node::getName();
  // One that is there already stays. Of two that start at once the first by name does.
  if (isTaken(node, [](const std::string& /*other*/) { return true; })) return EXIT_FAILURE;
  const auto options = execution::ExecutorOptions::atTheStart(private_node);
  execution::PlanExecutor executor(node, private_node, default_kind);
  if (isTaken(node, [&](const std::string& other) { return other < name; })) return EXIT_FAILURE;
  std::optional<execution::AutoExecution> automatic;
  if (options.auto_execute) {
    automatic.emplace(node, options.aligner,
                      [&executor](const Plan& plan) { executor.submit(plan, "auto_execute"); });
  }
  // Goals, cancels, what servers say and frames each find a thread.
  ros::AsyncSpinner spinner(4);
  spinner.start();
  ros_common::waitForShutdownRequest();
  executor.endGoals();
  ros_common::flushPublished();
  spinner.stop();
  ros::shutdown();
  return EXIT_SUCCESS;
}

}  // namespace goal_alignment::nodes
