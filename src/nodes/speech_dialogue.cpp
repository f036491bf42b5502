// SPDX-License-Identifier: BSD-3-Clause
// Answers ask_human by asking a person aloud.
#include "goal_alignment/dialogues/speech_dialogue.h"

#include <ros/ros.h>

#include <exception>
#include <iostream>

#include "goal_alignment/ros_common/deferred_shutdown.h"
#include "goal_alignment/ros_common/utf8_log.h"

int main(int argc, char** argv) {
  goal_alignment::ros_common::logInUtf8();
  ros::init(argc, argv, "speech_dialogue");
  goal_alignment::ros_common::shutDownOnSigterm();
  try {
    goal_alignment::dialogues::SpeechDialogue dialogue{ros::NodeHandle{}, ros::NodeHandle{"~"}};
    ros::AsyncSpinner spinner(3);  // a second asker waits for the first
    spinner.start();
    dialogue.run();
    spinner.stop();
  } catch (const std::exception& error) {
    // Not ROS_FATAL: the node handles are gone, and with them roscpp's log.
    std::cerr << "speech_dialogue: " << error.what() << std::endl;
    return 1;
  }
}
