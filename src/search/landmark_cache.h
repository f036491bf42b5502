// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <unordered_map>
#include <utility>

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

  void insert(StateId id, const heuristics::Landmarks& landmarks) {
    const auto [entry, is_new] = landmarks_.insert_or_assign(id, landmarks);
    if (is_new) order_.push_back(id);
    bytes_ += entry->second.bytes();
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
