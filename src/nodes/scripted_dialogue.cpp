// SPDX-License-Identifier: BSD-3-Clause
// Answers ask_human from a list of wanted fluents.
#include "goal_alignment/ros_interface/scripted_dialogue.h"

#include <ros/ros.h>

#include <exception>

int main(int argc, char** argv) {
  ros::init(argc, argv, "scripted_dialogue");
  try {
    const goal_alignment::ros_interface::ScriptedDialogue dialogue{ros::NodeHandle{},
                                                                   ros::NodeHandle{"~"}};
    ros::AsyncSpinner spinner(2);  // a second asker need not wait for the first
    spinner.start();
    ros::waitForShutdown();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
