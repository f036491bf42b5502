// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "goal_alignment/task/task.h"

namespace goal_alignment::heuristics {

/// The queue of the heuristics' Dijkstra explorations: buckets while the keys stay small (they
/// nearly always do), one binary heap from the first large key on. Keys never fall below the last
/// one popped, as Dijkstra's don't.
class PriorityQueue {
 public:
  using Key = task::Cost;
  using Entry = std::pair<Key, std::uint32_t>;

  void push(Key key, std::uint32_t value) {
    ++size_;
    if (key > kLargestBucket) {
      heap_.emplace_back(key, value);
      std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
      return;
    }
    const auto bucket = static_cast<std::size_t>(key);
    if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
    if (bucket < current_) current_ = bucket;
    buckets_[bucket].push_back(value);
  }

  bool empty() const { return size_ == 0; }

  /// The entry with the smallest key; the queue must not be empty.
  Entry pop() {
    --size_;
    while (current_ < buckets_.size() && buckets_[current_].empty())
      ++current_;
    if (current_ < buckets_.size()) {
      const std::uint32_t value = buckets_[current_].back();
      buckets_[current_].pop_back();
      return {static_cast<Key>(current_), value};
    }
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const Entry entry = heap_.back();
    heap_.pop_back();
    return entry;
  }

  void clear() {
    for (auto& bucket : buckets_)
      bucket.clear();
    heap_.clear();
    current_ = 0;
    size_ = 0;
  }

 private:
  static constexpr Key kLargestBucket = 1 << 14;

  std::vector<std::vector<std::uint32_t>> buckets_;
  std::vector<Entry> heap_;
  std::size_t current_ = 0;
  std::size_t size_ = 0;
};

}  // namespace goal_alignment::heuristics
