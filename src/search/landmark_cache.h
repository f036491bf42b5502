// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <unordered_map>

#include "goal_alignment/heuristics/landmarks.h"
#include "goal_alignment/search/state_registry.h"

namespace goal_alignment::search {

/// The landmarks of the states evaluated last, within so many bytes; the oldest go first.
class LandmarkCache {
 public:
  explicit LandmarkCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  const heuristics::Landmarks* find(StateId id) const {
    const auto found = landmarks_.find(id);
    return found == landmarks_.end() ? nullptr : &found->second;
  }

  /// O(landmarks), and O(states in the cache) for one that is there already.
  void insert(StateId id, const heuristics::Landmarks& landmarks) {
    const auto [entry, is_new] = landmarks_.try_emplace(id);
    if (!is_new) {
      bytes_ -= entry->second.bytes();
      order_.erase(std::find(order_.begin(), order_.end(), id));
    }
    entry->second = landmarks;
    order_.push_back(id);
    bytes_ += landmarks.bytes();
    while (bytes_ > most_bytes_ && order_.size() > 1) {
      const auto oldest = landmarks_.find(order_.front());
      bytes_ -= oldest->second.bytes();
      landmarks_.erase(oldest);
      order_.pop_front();
    }
  }

  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::unordered_map<StateId, heuristics::Landmarks> landmarks_;
  std::deque<StateId> order_;
};

}  // namespace goal_alignment::search
