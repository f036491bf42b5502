// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <chrono>
#include <cstdint>
#include <memory>

namespace goal_alignment::any_message {

using Clock = std::chrono::steady_clock;

/// So many seconds from now.
inline Clock::time_point deadlineIn(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

enum class ClockKind : std::uint8_t {
  Wall,
  Ros  ///< the simulation's, which may run slower, stand still and be set back
};

/// Measures time from when it was made. Not thread-safe.
class Timer {
 public:
  explicit Timer(ClockKind kind);

  /// Of ROS's clock what it has gone forward: it has begun to run with its first tick, and what it
  /// was set back is not lost.
  double seconds();

 private:
  ClockKind kind_;
  Clock::time_point begin_ = Clock::now();
  ros::Time last_;
  double passed_ = 0;
};

/// When something is to end: at a time of the wall's clock, and after so many seconds of a timer.
class TimeLimit {
 public:
  TimeLimit() = default;                              ///< never
  TimeLimit(Clock::time_point wall) : wall_(wall) {}  // NOLINT: a time on the wall is one

  /// So many seconds from now; 0: never.
  static TimeLimit after(double seconds, ClockKind kind);

  bool isOver() const;
  Clock::time_point wall() const { return wall_; }

  /// The same, but at that time at the latest.
  TimeLimit capped(Clock::time_point wall) const;

 private:
  Clock::time_point wall_ = Clock::time_point::max();
  std::shared_ptr<Timer> timer_;  // null: the wall's clock alone counts
  double seconds_ = 0;
};

}  // namespace goal_alignment::any_message
