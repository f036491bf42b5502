// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/source_position.h"

namespace goal_alignment::pddl {

/// Input that can't be used. what() is `file:line:column: message`, one line a fault.
class InputError : public Exception {
 public:
  InputError(const std::string& source_name, SourcePosition position, const std::string& message);

  const std::string& sourceName() const noexcept { return source_name_; }
  SourcePosition position() const noexcept { return position_; }

 private:
  std::string source_name_;
  SourcePosition position_;
};

/// The text is no PDDL: says what was expected and what stood there.
class SyntaxError : public InputError {
 public:
  using InputError::InputError;
};

/// The text is PDDL, but contradicts itself or the other file (undeclared, twice, arity, types …).
class SemanticError : public InputError {
 public:
  using InputError::InputError;
};

/// Good PDDL that this program can't treat: `not supported yet: <construct>`.
class UnsupportedError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace goal_alignment::pddl
