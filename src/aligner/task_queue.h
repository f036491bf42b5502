// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/WaitingTask.h"

namespace goal_alignment::aligner {

/// Tasks that wait until a plan has been carried out, the one that came first first. `Ticket`
/// stands for the goal. Not thread-safe.
template <typename Ticket>
class TaskQueue {
 public:
  static constexpr std::size_t kMost = 4;

  struct Entry {
    WaitingTask shown;
    std::string identity;          ///< equal for equal tasks
    bool refused_if_busy = false;  ///< waits only until it is known whether a plan is carried out
    unsigned statuses_before = 0;  ///< of the executor, when it came
    Ticket ticket;
  };

  bool empty() const { return entries_.empty(); }
  bool isFull() const { return entries_.size() >= kMost; }

  bool holds(const std::string& identity) const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const Entry& entry) { return entry.identity == identity; });
  }

  /// An equal task that waits gives its place to this one, and is returned.
  std::optional<Entry> add(Entry entry) {
    for (Entry& waiting : entries_) {
      if (waiting.identity != entry.identity) continue;
      entry.shown.since = waiting.shown.since;
      return std::exchange(waiting, std::move(entry));
    }
    entries_.push_back(std::move(entry));
    return std::nullopt;
  }

  /// One that was to begin already, so that it is not too many.
  void addFirst(Entry entry) { entries_.push_front(std::move(entry)); }

  std::optional<Entry> takeFirst() {
    if (entries_.empty()) return std::nullopt;
    Entry first = std::move(entries_.front());
    entries_.pop_front();
    return first;
  }

  /// Takes out all that fit.
  template <typename Fits>
  std::vector<Entry> takeAll(const Fits& fits) {
    const auto rest = std::stable_partition(entries_.begin(), entries_.end(),
                                            [&](const Entry& entry) { return !fits(entry); });
    std::vector<Entry> taken(std::make_move_iterator(rest),
                             std::make_move_iterator(entries_.end()));
    entries_.erase(rest, entries_.end());
    return taken;
  }

  /// As ~state has them.
  std::vector<WaitingTask> shown() const {
    std::vector<WaitingTask> tasks;
    for (const Entry& entry : entries_)
      tasks.push_back(entry.shown);
    return tasks;
  }

 private:
  std::deque<Entry> entries_;
};

}  // namespace goal_alignment::aligner
