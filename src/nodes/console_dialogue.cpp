// SPDX-License-Identifier: BSD-3-Clause
// Answers ask_human by asking a person in this terminal, who hears how tasks end, too, and may
// choose what to do instead.
#include "goal_alignment/dialogues/console_dialogue.h"

#include <ros/ros.h>
#include <unistd.h>

#include <exception>
#include <iostream>
#include <thread>

#include "goal_alignment/aligner/phrases_file.h"
#include "goal_alignment/dialogues/outcome_watch.h"
#include "goal_alignment/dialogues/vocabulary_file.h"
#include "goal_alignment/ros_common/deferred_shutdown.h"
#include "goal_alignment/ros_common/utf8_log.h"

namespace {

using namespace goal_alignment;  // NOLINT(google-build-using-namespace): a main of one file
using dialogues::ConsoleDialogue;
using dialogues::OutcomeWatch;
using dialogues::PromptedTerminal;
using goal_alignment::phrasing::Phrases;

constexpr double kLookPeriod = 0.05;  // seconds

// Only for its language, so that it is no reason not to ask.
Phrases phrasesOfParameter() {
  try {
    return aligner::phrasesOf(ros::NodeHandle("~").param<std::string>("phrases", ""));
  } catch (const std::exception& error) {
    ROS_WARN("no phrases: %s", error.what());
    return {};
  }
}

void tellEnd(const goal_alignment::AlignmentState& end, OutcomeWatch& ends,
             ConsoleDialogue& dialogue, PromptedTerminal& terminal, const Phrases& phrases) {
  terminal.write("\n" + end.message + "\n");
  if (end.alternatives.empty()) return;
  const auto chosen = dialogue.choose(end.alternatives, [&] { return ends.isGone(end); });
  if (!chosen && !ends.isGone(end) && !dialogue.hasEnded())
    terminal.write(phrases.say("ask_left_at_that") + "\n");
  if (chosen && !ends.takeUp(end, end.alternatives.at(*chosen), end.person))
    terminal.write(phrases.say("ask_nobody_goes_on") + "\n");
}

void tellEnds(OutcomeWatch& ends, ConsoleDialogue& dialogue, PromptedTerminal& terminal,
              const Phrases& phrases) {
  while (ros::ok() && !dialogue.hasEnded()) {
    if (const auto end = ends.takeEnd()) tellEnd(*end, ends, dialogue, terminal, phrases);
    ros::WallDuration(kLookPeriod).sleep();
  }
}

void run() {
  const std::string vocabulary =
      ros::NodeHandle("~").param<std::string>("vocabulary", dialogues::kDefaultVocabulary);
  const Phrases phrases = phrasesOfParameter();
  OutcomeWatch ends{ros::NodeHandle{}};  // before there can be a question
  PromptedTerminal terminal(std::cout);
  ConsoleDialogue dialogue(ros::NodeHandle{}, STDIN_FILENO, terminal,
                           dialogues::vocabularyOf(vocabulary), phrases);
  ros::AsyncSpinner spinner(2);  // a second asker waits for the first
  spinner.start();
  std::thread talk([&] { tellEnds(ends, dialogue, terminal, phrases); });
  dialogue.run();
  talk.join();
  ros::shutdown();
  spinner.stop();
}

}  // namespace

int main(int argc, char** argv) {
  ros_common::logInUtf8();
  ros::init(argc, argv, "console_dialogue");
  ros_common::shutDownOnSigterm();
  try {
    run();
  } catch (const std::exception& error) {
    std::cerr << "console_dialogue: " << error.what() << std::endl;
    return 1;
  }
}
