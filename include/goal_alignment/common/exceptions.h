// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

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

/// Throws LimitReached where there is a reason to stop. Its words, `during` and then `what`, are
/// put together only then, so that it may stand in the innermost loops.
inline void throwIfReached(LimitReason reason, const char* during, std::string_view what = {}) {
  if (reason != LimitReason::None) throw LimitReached(reason, std::string(during).append(what));
}

/// LimitMonitor::poll() for work that has no partial result.
inline void pollOrThrow(LimitMonitor& monitor, const char* during, std::string_view what = {}) {
  throwIfReached(monitor.poll(), during, what);
}

}  // namespace goal_alignment
