// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"

namespace goal_alignment::achievability {

/// The conflicts known, none of them a superset of a proven other.
class ConflictSet {
 public:
  explicit ConflictSet(std::size_t candidates) : candidates_(candidates) {}

  /// Adds what says something new and drops what the new one makes superfluous; true when added.
  /// O(conflicts · candidates / 64).
  bool add(const Conflict& conflict);

  /// A proven conflict within the set.
  const Conflict* provenWithin(const CandidateSet& set) const;

  /// Takes out the suspected conflicts within a set that turned out to be achievable.
  void clearSuspectedWithin(const CandidateSet& achievable);

  /// All conflicts are known and proven, so none has a smaller one within it.
  void markMinimal();

  const std::vector<Conflict>& all() const { return conflicts_; }

  /// The minimal sets that hit every conflict, or nothing when there are more than `most` of them.
  /// Incremental (Berge, "Hypergraphs", 1989): exponential in the worst case, hence the bound.
  const std::vector<CandidateSet>* minimalHittingSets(std::size_t most);

 private:
  std::size_t candidates_;
  std::vector<Conflict> conflicts_;
  std::vector<CandidateSet> hitting_sets_;
  std::size_t hit_count_ = 0;  // conflicts that hitting_sets_ takes into account
  bool hitting_sets_valid_ = false;
};

}  // namespace goal_alignment::achievability
