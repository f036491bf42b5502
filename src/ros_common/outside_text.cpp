// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/outside_text.h"

#include "goal_alignment/common/quote.h"

namespace goal_alignment::ros_common {
namespace {

constexpr std::size_t kLongestName = 200;  // bytes

// Where U+0080 to U+009F begins, which are control characters as well.
bool isLateControl(const std::string& text, std::size_t i) {
  if (text[i] != '\xc2' || i + 1 == text.size()) return false;
  const auto next = static_cast<unsigned char>(text[i + 1]);
  return next >= 0x80 && next < 0xa0;
}

}  // namespace

std::string onOneLine(std::string_view text, std::size_t most) {
  std::string line = shortened(text, most);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if ((c >= 0 && c < ' ') || c == '\x7f') line[i] = ' ';
    if (isLateControl(line, i)) line[i] = line[i + 1] = ' ';
  }
  return line;
}

std::string outsideName(std::string_view text) {
  return onOneLine(text, kLongestName);
}

}  // namespace goal_alignment::ros_common
