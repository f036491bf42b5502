// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace goal_alignment::execution {

using Clock = std::chrono::steady_clock;

/// So many seconds from now.
inline Clock::time_point deadlineIn(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// The end of a time-out that begins now; 0: there is none.
inline Clock::time_point timeoutIn(double seconds) {
  return seconds > 0 ? deadlineIn(seconds) : Clock::time_point::max();
}

/// Where the thread that runs a plan waits, in wall time: until what it waits for holds, an
/// interrupt comes, or the time is over. Thread-safe.
class WaitPoint {
 public:
  enum class Woken { Holds, Interrupt, Timeout };

  /// The plan that runs is to stop; stays so until clear().
  void interrupt() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      interrupted_ = true;
    }
    changed_.notify_all();
  }

  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    interrupted_ = false;
  }

  bool interrupted() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return interrupted_;
  }

  /// Something that a wait looks at may have changed. Without it a wait looks every 20 ms.
  void notify() {
    { const std::lock_guard<std::mutex> lock(mutex_); }  // so that no wait begins in between
    changed_.notify_all();
  }

  /// `holds` is called without any lock held.
  template <typename Predicate>
  Woken waitUntil(Clock::time_point end, Predicate holds) {
    return wait(end, holds, true);
  }

  /// The same, deaf to interrupts: for what ends soon anyway.
  template <typename Predicate>
  Woken settleUntil(Clock::time_point end, Predicate holds) {
    return wait(end, holds, false);
  }

  /// Until the time is over or an interrupt comes; true: it came.
  bool pauseUntil(Clock::time_point end) {
    return waitUntil(end, [] { return false; }) == Woken::Interrupt;
  }

 private:
  static constexpr std::chrono::milliseconds kPoll{20};

  template <typename Predicate>
  Woken wait(Clock::time_point end, Predicate& holds, bool interruptible) {
    while (true) {
      if (holds()) return Woken::Holds;
      std::unique_lock<std::mutex> lock(mutex_);
      if (interruptible && interrupted_) return Woken::Interrupt;
      const auto now = Clock::now();
      if (now >= end) return Woken::Timeout;
      changed_.wait_until(lock, std::min(end, now + kPoll));
    }
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool interrupted_ = false;
};

}  // namespace goal_alignment::execution
