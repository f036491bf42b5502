// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "goal_alignment/common/limits.h"

namespace goal_alignment {

/// Base of everything the core throws on purpose.
class Exception : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A limit or a cancel stopped work that has no partial result (grounding, mutex tables).
/// Searches never throw it: running out is one of their three values.
class LimitReached : public Exception {
 public:
  LimitReached(LimitReason reason, const std::string& during);
  LimitReason reason() const noexcept { return reason_; }

 private:
  LimitReason reason_;
};

}  // namespace goal_alignment
