// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/limits.h"

#include <algorithm>

namespace goal_alignment {

const char* toString(LimitReason reason) noexcept {
  switch (reason) {
    case LimitReason::None:
      return "none";
    case LimitReason::States:
      return "states";
    case LimitReason::Memory:
      return "memory";
    case LimitReason::Time:
      return "time";
    case LimitReason::Cancelled:
      return "canceled";
  }
  return "unknown";
}

Limits Limits::withStates(std::uint64_t count) const {
  Limits narrowed = *this;
  narrowed.states = std::min(states, count);
  return narrowed;
}

Limits Limits::withSeconds(double seconds) const {
  Limits narrowed = *this;
  // Beyond a year a double of nanoseconds may overflow the clock: that is "no limit" to anyone.
  constexpr double kYear = 365.0 * 24 * 3600;
  if (seconds < kYear) {
    const auto span =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    narrowed.deadline = std::min(deadline, Clock::now() + span);
  }
  return narrowed;
}

LimitReason Limits::interruption() const noexcept {
  if (cancel != nullptr && cancel->cancelled()) return LimitReason::Cancelled;
  return Clock::now() >= deadline ? LimitReason::Time : LimitReason::None;
}

}  // namespace goal_alignment
