// SPDX-License-Identifier: BSD-3-Clause
// Aligns people's tasks with what the robot can do: doc/interface.md.
#include <ros/ros.h>

#include "goal_alignment/aligner/aligner_node.h"
#include "goal_alignment/ros_common/deferred_shutdown.h"
#include "goal_alignment/ros_common/names.h"

int main(int argc, char** argv) {
  namespace ros_common = goal_alignment::ros_common;
  ros_common::initWithDeferredShutdown(argc, argv, ros_common::kDefaultNodeName);
  goal_alignment::aligner::AlignerNode node{ros::NodeHandle{}, ros::NodeHandle{"~"}};
  // Goals, cancels, answers and tasks each find a thread.
  ros::AsyncSpinner spinner(4);
  spinner.start();
  ros_common::waitForShutdownRequest();
  node.endGoals();
  ros_common::flushPublished();
  spinner.stop();
  ros::shutdown();
}
