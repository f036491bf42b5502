// SPDX-License-Identifier: BSD-3-Clause
// Aligns people's tasks with what the robot can do: README.md, "Interface".
#include <ros/ros.h>

#include "goal_alignment/ros_interface/aligner_node.h"
#include "goal_alignment/ros_interface/graceful_end.h"
#include "goal_alignment/ros_interface/node_constants.h"

int main(int argc, char** argv) {
  using namespace goal_alignment::ros_interface;  // NOLINT(google-build-using-namespace)
  initWithLastWords(argc, argv, kDefaultNodeName);
  AlignerNode node{ros::NodeHandle{}, ros::NodeHandle{"~"}};
  // Goals, cancels, answers and tasks each find a thread.
  ros::AsyncSpinner spinner(4);
  spinner.start();
  waitUntilToldToEnd();
  node.endGoals();
  flushPublished();
  spinner.stop();
  ros::shutdown();
}
