// SPDX-License-Identifier: BSD-3-Clause
// Answers ask_human by asking a person in this terminal.
#include "goal_alignment/ros_interface/console_dialogue.h"

#include <ros/ros.h>
#include <unistd.h>

#include <iostream>

#include "goal_alignment/ros_interface/graceful_end.h"
#include "goal_alignment/ros_interface/model_source.h"
#include "goal_alignment/ros_interface/utf8_log.h"

namespace {

// Only for its language, so that it is no reason not to ask.
goal_alignment::phrasing::Phrases phrasesOfParameter() {
  try {
    return goal_alignment::ros_interface::phrasesOf(
        ros::NodeHandle("~").param<std::string>("phrases", ""));
  } catch (const std::exception& error) {
    ROS_WARN("no phrases: %s", error.what());
    return {};
  }
}

}  // namespace

int main(int argc, char** argv) {
  goal_alignment::ros_interface::logInUtf8();
  ros::init(argc, argv, "console_dialogue");
  goal_alignment::ros_interface::endOnSigterm();
  goal_alignment::ros_interface::ConsoleDialogue dialogue(ros::NodeHandle{}, STDIN_FILENO,
                                                          std::cout, phrasesOfParameter());
  ros::AsyncSpinner spinner(2);  // a second asker waits for the first
  spinner.start();
  dialogue.run();
  ros::shutdown();
  spinner.stop();
}
