// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/search/search_space.h"

namespace goal_alignment::achievability {

/// The sets of candidates that hold in the states visited so far, and which of them are maximal.
class SeenSets {
 public:
  using Seen = std::pair<CandidateSet, search::StateId>;

  explicit SeenSets(std::size_t candidates)
      : bytes_per_set_(sizeof(Seen) + 4 * sizeof(void*) + candidates / 8) {}

  /// O(maximal sets) for a set that is new, else O(candidates).
  void add(const CandidateSet& set, search::StateId id) {
    if (!seen_.insert(set).second) return;
    const auto covers = [&](const Seen& known) { return set.is_subset_of(known.first); };
    if (std::any_of(maximal_.begin(), maximal_.end(), covers)) return;
    const auto covered = [&](const Seen& known) { return known.first.is_subset_of(set); };
    maximal_.erase(std::remove_if(maximal_.begin(), maximal_.end(), covered), maximal_.end());
    maximal_.emplace_back(set, id);
  }

  /// Each with the first state in which it held.
  const std::vector<Seen>& maximal() const { return maximal_; }

  /// About what this takes.
  std::size_t bytes() const { return (seen_.size() + maximal_.capacity()) * bytes_per_set_; }

 private:
  std::size_t bytes_per_set_;
  std::unordered_set<CandidateSet> seen_;
  std::vector<Seen> maximal_;
};

}  // namespace goal_alignment::achievability
