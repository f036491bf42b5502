// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace goal_alignment::ros_common {

/// Text from outside for one line of a log or a screen: control characters, which a terminal takes
/// for commands, become blanks, and what is longer than `most` bytes is cut short with `…`.
std::string onOneLine(std::string_view text, std::size_t most);

/// The same for the name of a person, a program or a task.
std::string outsideName(std::string_view text);

}  // namespace goal_alignment::ros_common
