// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace goal_alignment {

/// Stops work that runs in another thread. The only object of the core that threads share.
class CancelToken {
 public:
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  void reset() noexcept { cancelled_.store(false, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> cancelled_{false};
};

/// Why work stopped before it was done. None: it did not.
enum class LimitReason : std::uint8_t { None, States, Memory, Time, Cancelled };

/// `states`, `memory`, … for messages and JSON.
const char* toString(LimitReason reason) noexcept;

/// What may be accounted for where so much memory may be taken: a fifth is left to the allocator,
/// and to what nobody counts.
constexpr std::size_t accountable(std::size_t memory) {
  return memory - memory / 5;
}

/// How much one piece of work may use. States and bytes come first and replay exactly; wall time
/// comes last, as the bound that a person feels.
struct Limits {
  using Clock = std::chrono::steady_clock;

  std::uint64_t states = std::numeric_limits<std::uint64_t>::max();  ///< generated states
  std::size_t bytes = std::numeric_limits<std::size_t>::max();       ///< accounted bytes
  Clock::time_point deadline = Clock::time_point::max();
  const CancelToken* cancel = nullptr;  ///< not owned; may be null

  /// The same limits with at most `count` generated states.
  Limits withStates(std::uint64_t count) const;
  /// The same limits, ending at most `seconds` from now.
  Limits withSeconds(double seconds) const;
  /// Whether a person or the clock has ended the work by now: Cancelled, Time or None.
  LimitReason interruption() const noexcept;
};

/// Counts what one piece of work has used and says when to stop. Poll it at every generated state:
/// the cancel token is read each time, the clock at every 16th poll.
class LimitMonitor {
 public:
  explicit LimitMonitor(const Limits& limits) : limits_(limits) {}

  /// Counts one generated state; `bytes` is what the caller holds at the moment.
  LimitReason generated(std::size_t bytes = 0) noexcept {
    if (++states_ > limits_.states) return LimitReason::States;
    if (bytes > limits_.bytes) return LimitReason::Memory;
    return poll();
  }

  /// The same without counting: for loops that generate no states (grounding, mutex tables).
  LimitReason poll() noexcept {
    if (limits_.cancel != nullptr && limits_.cancel->cancelled()) return LimitReason::Cancelled;
    if ((++polls_ & 15U) == 0 && Limits::Clock::now() >= limits_.deadline) return LimitReason::Time;
    return LimitReason::None;
  }

  std::uint64_t states() const noexcept { return states_; }

 private:
  Limits limits_;
  std::uint64_t states_ = 0;
  std::uint32_t polls_ = 0;
};

}  // namespace goal_alignment
