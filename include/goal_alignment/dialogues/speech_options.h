// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "goal_alignment/dialogues/vocabulary_file.h"

namespace goal_alignment::dialogues {

/// The private parameters of speech_dialogue, read at its start. README.md's table lists them in
/// this order.
struct SpeechOptions {
  std::string vocabulary = kDefaultVocabulary;  ///< absolute, or below the package's folder
  /// Program and arguments; {text}, {voice} and {rate} are filled in. Empty: nothing is said aloud.
  std::vector<std::string> say_command = {"espeak-ng", "-v", "{voice}", "-s",
                                          "{rate}",    "--", "{text}"};
  std::string voice = "en";
  int rate = 160;                 ///< words a minute, 80 … 450
  double say_timeout = 60;        ///< seconds, 1 … 600, after which what is being said is cut off
  double echo_time = 0.5;         ///< seconds, 0 … 10: for so long after it spoke it hears itself
  double reply_timeout = 15;      ///< seconds, 0.1 … 3600, until the question is put again
  int retries = 2;                ///< 0 … 100: how often for silence, and how often for "sorry?"
  std::string person = "speech";  ///< who has answered where the question names nobody

  std::vector<std::string> unknown;  ///< unknown private parameters

  /// Both throw ParameterError.
  static SpeechOptions read(const ros::NodeHandle& private_node);
  static SpeechOptions read(const XmlRpc::XmlRpcValue& values, const std::string& ns);

  /// What to start so that `text` is heard; empty where nothing is.
  std::vector<std::string> commandFor(const std::string& text) const;
};

}  // namespace goal_alignment::dialogues
