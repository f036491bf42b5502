// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/any_message/arguments.h"
#include "goal_alignment/any_message/message_definition.h"

namespace goal_alignment::any_message::test {

inline ActionDispatch step(const std::string& name,
                           const std::vector<std::pair<std::string, std::string>>& parameters) {
  ActionDispatch message;
  message.name = name;
  for (const auto& [key, value] : parameters) {
    message.parameters.emplace_back();
    message.parameters.back().key = key;
    message.parameters.back().value = value;
  }
  return message;
}

/// Types of definitions at hand, and the usual ones that they use.
inline MessageTypes typesOf(std::map<std::string, std::string> files) {
  files.emplace("std_msgs/msg/Header", "uint32 seq\ntime stamp\nstring frame_id\n");
  files.emplace("actionlib_msgs/msg/GoalID", "time stamp\nstring id\n");
  return MessageTypes([files](const std::string& package, const std::string& folder,
                              const std::string& name) -> std::optional<std::string> {
    const auto found = files.find(package + "/" + folder + "/" + name);
    return found == files.end() ? std::nullopt : std::make_optional(found->second);
  });
}

/// What a call throws, or "".
template <typename Call>
std::string faultOfCall(Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace goal_alignment::any_message::test
