// SPDX-License-Identifier: BSD-3-Clause
// Answers ask_human from a list of wanted fluents.
#include "goal_alignment/ros_interface/scripted_dialogue.h"

#include <ros/ros.h>

#include <exception>
#include <iostream>

#include "goal_alignment/ros_interface/graceful_end.h"
#include "goal_alignment/ros_interface/utf8_log.h"

int main(int argc, char** argv) {
  goal_alignment::ros_interface::logInUtf8();
  ros::init(argc, argv, "scripted_dialogue");
  goal_alignment::ros_interface::endOnSigterm();
  try {
    const goal_alignment::ros_interface::ScriptedDialogue dialogue{ros::NodeHandle{},
                                                                   ros::NodeHandle{"~"}};
    ros::AsyncSpinner spinner(2);  // a second asker need not wait for the first
    spinner.start();
    ros::waitForShutdown();
  } catch (const std::exception& error) {
    // Not ROS_FATAL: the node handles are gone, and with them roscpp's log.
    std::cerr << "scripted_dialogue: " << error.what() << std::endl;
    return 1;
  }
}
