// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::pddl {

namespace {

std::string located(const std::string& source_name, SourcePosition position,
                    const std::string& message) {
  std::string text = source_name;
  if (position.line > 0) {
    text += ":" + std::to_string(position.line) + ":" + std::to_string(position.column);
  }
  return text + ": " + message;
}

}  // namespace

InputError::InputError(const std::string& source_name, SourcePosition position,
                       const std::string& message)
    : Exception(located(source_name, position, message)),
      source_name_(source_name),
      position_(position) {}

}  // namespace goal_alignment::pddl
