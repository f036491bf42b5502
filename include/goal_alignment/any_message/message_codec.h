// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <string>
#include <vector>

#include "goal_alignment/any_message/arguments.h"
#include "goal_alignment/any_message/message_definition.h"

namespace goal_alignment::any_message {

using Bytes = std::vector<std::uint8_t>;

/// The message as ROS sends it, from the fields that YAML gives; those left out are zero, empty or
/// false, and the stamp of a header is `now`. A time is `now` or seconds. Throws YamlError, and
/// TypeError where a part's type is not known.
Bytes encode(MessageTypes& types, const MessageDefinition& definition, const YAML::Node& fields,
             const Arguments& arguments, const ros::Time& now);

/// As much of this as can be said without arguments: fields that the type does not have, lists and
/// maps where none may stand. `source` names the file in errors. Throws like encode().
void check(MessageTypes& types, const MessageDefinition& definition, const YAML::Node& fields,
           const std::string& source);

/// The type of the field at the path, `a.b.c`, which is built in, so that matches() can look at it.
/// Throws TypeError that says where the path goes astray.
std::string typeAt(MessageTypes& types, const MessageDefinition& definition,
                   const std::string& path);

/// Whether a value is of the type of the field at that path, which typeAt() knows.
/// Throws YamlError.
void checkValue(MessageTypes& types, const MessageDefinition& definition, const std::string& path,
                const YAML::Node& expected, const Arguments& arguments);

/// Whether the message has that value there; `found` becomes what it has, for people. Throws
/// YamlError for a value of another type, TypeError for bytes that are no such message.
bool matches(MessageTypes& types, const MessageDefinition& definition, const Bytes& message,
             const std::string& path, const YAML::Node& expected, const Arguments& arguments,
             std::string& found);

}  // namespace goal_alignment::any_message
