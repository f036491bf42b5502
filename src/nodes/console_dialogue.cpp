// SPDX-License-Identifier: BSD-3-Clause
// Answers ask_human by asking a person in this terminal, who hears how tasks end, too, and may
// choose what to do instead.
#include "goal_alignment/ros_interface/console_dialogue.h"

#include <ros/ros.h>
#include <unistd.h>

#include <exception>
#include <iostream>
#include <thread>

#include "goal_alignment/ros_interface/graceful_end.h"
#include "goal_alignment/ros_interface/outcome_watch.h"
#include "goal_alignment/ros_interface/vocabulary_file.h"

namespace {

using namespace goal_alignment::ros_interface;  // NOLINT(google-build-using-namespace): a main

constexpr double kLookPeriod = 0.05;  // seconds

void tellEnd(const goal_alignment::AlignmentState& end, OutcomeWatch& ends,
             ConsoleDialogue& dialogue, PromptedTerminal& terminal) {
  terminal.write("\n" + end.message + "\n");
  if (end.alternatives.empty()) return;
  const auto chosen = dialogue.choose(end.alternatives, [&] { return ends.isGone(end); });
  if (!chosen && !ends.isGone(end) && !dialogue.hasEnded()) terminal.write("So it is left.\n");
  if (chosen && !ends.takeUp(end, end.alternatives.at(*chosen), end.person))
    terminal.write("Nobody is there to go on with that.\n");
}

void tellEnds(ConsoleDialogue& dialogue, PromptedTerminal& terminal) {
  OutcomeWatch ends{ros::NodeHandle{}};
  while (ros::ok() && !dialogue.hasEnded()) {
    if (const auto end = ends.takeEnd()) tellEnd(*end, ends, dialogue, terminal);
    ros::WallDuration(kLookPeriod).sleep();
  }
}

void run() {
  const std::string vocabulary =
      ros::NodeHandle("~").param<std::string>("vocabulary", kDefaultVocabulary);
  PromptedTerminal terminal(std::cout);
  ConsoleDialogue dialogue(ros::NodeHandle{}, STDIN_FILENO, terminal, vocabularyOf(vocabulary));
  ros::AsyncSpinner spinner(2);  // a second asker waits for the first
  spinner.start();
  std::thread ends([&] { tellEnds(dialogue, terminal); });
  dialogue.run();
  ends.join();
  ros::shutdown();
  spinner.stop();
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "console_dialogue");
  endOnSigterm();
  try {
    run();
  } catch (const std::exception& error) {
    std::cerr << "console_dialogue: " << error.what() << std::endl;
    return 1;
  }
}
