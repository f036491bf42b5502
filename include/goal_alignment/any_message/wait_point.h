// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "goal_alignment/any_message/time_limit.h"

namespace goal_alignment::any_message {

/// Where the thread that runs a plan waits: until what it waits for holds, an
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
  Woken waitUntil(const TimeLimit& end, Predicate holds) {
    return wait(end, holds, true);
  }

  /// The same, deaf to interrupts: for what ends soon anyway.
  template <typename Predicate>
  Woken settleUntil(const TimeLimit& end, Predicate holds) {
    return wait(end, holds, false);
  }

  /// Until the time is over or an interrupt comes; true: it came.
  bool pauseUntil(const TimeLimit& end) {
    return waitUntil(end, [] { return false; }) == Woken::Interrupt;
  }

 private:
  static constexpr std::chrono::milliseconds kPoll{20};

  template <typename Predicate>
  Woken wait(const TimeLimit& end, Predicate& holds, bool interruptible) {
    while (true) {
      if (holds()) return Woken::Holds;
      std::unique_lock<std::mutex> lock(mutex_);
      if (interruptible && interrupted_) return Woken::Interrupt;
      if (end.isOver()) return Woken::Timeout;
      changed_.wait_until(lock, std::min(end.wall(), Clock::now() + kPoll));
    }
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool interrupted_ = false;
};

}  // namespace goal_alignment::any_message
