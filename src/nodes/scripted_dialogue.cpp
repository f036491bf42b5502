// SPDX-License-Identifier: BSD-3-Clause
// Answers ask_human from a list of wanted fluents.
#include "goal_alignment/dialogues/scripted_dialogue.h"

#include <ros/ros.h>

#include <exception>
#include <iostream>

#include "goal_alignment/ros_common/deferred_shutdown.h"
#include "goal_alignment/ros_common/utf8_log.h"

int main(int argc, char** argv) {
  goal_alignment::ros_common::logInUtf8();
  ros::init(argc, argv, "scripted_dialogue");
  goal_alignment::ros_common::shutDownOnSigterm();
  try {
    const goal_alignment::dialogues::ScriptedDialogue dialogue{ros::NodeHandle{},
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
