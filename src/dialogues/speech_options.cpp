// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/speech_options.h"

#include <algorithm>
#include <map>

#include "goal_alignment/ros_common/parameter_reader.h"

namespace goal_alignment::dialogues {
namespace {

constexpr const char* kTextGap = "{text}";

std::string filled(const std::string& argument, const std::map<std::string, std::string>& gaps) {
  const auto found = gaps.find(argument);
  return found == gaps.end() ? argument : found->second;
}

}  // namespace

SpeechOptions SpeechOptions::read(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue values;
  private_node.getParam(private_node.getNamespace(), values);
  return read(values, private_node.getNamespace());
}

SpeechOptions SpeechOptions::read(const XmlRpc::XmlRpcValue& values, const std::string& ns) {
  ros_common::ParameterReader reader(values, ns);
  SpeechOptions options;
  reader.read("vocabulary", options.vocabulary);
  reader.readTexts("say_command", options.say_command);
  const auto& command = options.say_command;
  const bool says_text = std::find(command.begin(), command.end(), kTextGap) != command.end();
  if (!command.empty() && (command.front().empty() || command.front() == kTextGap || !says_text))
    reader.refuse("say_command", "a program and its arguments, among them \"{text}\"");
  reader.read("voice", options.voice);
  if (options.voice.empty()) reader.refuse("voice", "the name of a voice");
  reader.read("rate", options.rate, 80, 450);
  reader.read("say_timeout", options.say_timeout, 1, 600);
  reader.read("echo_time", options.echo_time, 0, 10);
  reader.read("reply_timeout", options.reply_timeout, 0.1, 3600);
  reader.read("retries", options.retries, 0, 100);
  reader.read("person", options.person);
  if (options.person.empty()) reader.refuse("person", "a name");
  options.warnings = reader.warnings();
  return options;
}

// Arguments are filled in whole, so that no text can become an option or another argument.
std::vector<std::string> SpeechOptions::commandFor(const std::string& text) const {
  const std::map<std::string, std::string> gaps = {
      {kTextGap, text}, {"{voice}", voice}, {"{rate}", std::to_string(rate)}};
  std::vector<std::string> command;
  command.reserve(say_command.size());
  for (const std::string& argument : say_command)
    command.push_back(filled(argument, gaps));
  return command;
}

}  // namespace goal_alignment::dialogues
