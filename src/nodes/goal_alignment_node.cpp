// SPDX-License-Identifier: BSD-3-Clause
// Aligns people's tasks with what the robot can do: README.md, "Interface".
#include <ros/ros.h>

#include "goal_alignment/ros_interface/aligner_node.h"
#include "goal_alignment/ros_interface/node_constants.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, goal_alignment::ros_interface::kDefaultNodeName);
  goal_alignment::ros_interface::AlignerNode node{ros::NodeHandle{}, ros::NodeHandle{"~"}};
  // Goals, cancels, answers and tasks each find a thread.
  ros::AsyncSpinner spinner(4);
  spinner.start();
  ros::waitForShutdown();
  spinner.stop();
}
