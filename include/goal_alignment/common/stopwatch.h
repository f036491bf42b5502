// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace goal_alignment {

/// Wall time in seconds.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
  /// The seconds so far; begins anew.
  double lap() {
    const double so_far = seconds();
    began_ = Clock::now();
    return so_far;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point began_ = Clock::now();
};

}  // namespace goal_alignment
