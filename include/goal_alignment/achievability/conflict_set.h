// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"

namespace goal_alignment::achievability {

/// The conflicts known, none of them a superset of a proven other, no suspected one of a suspected
/// other.
class ConflictSet {
 public:
  /// Adds what says something new and drops what the new one makes superfluous; true when added.
  /// O(conflicts · candidates / 64).
  bool add(const Conflict& conflict);

  /// A proven conflict within the set.
  const Conflict* provenWithin(const CandidateSet& set) const;

  /// Takes out the suspected conflicts within a set that turned out to be achievable; true when
  /// there was any.
  bool clearSuspectedWithin(const CandidateSet& achievable);

  /// Calls a proven conflict minimal where each set with one member less is achievable, as
  /// `achievable(set)` says.
  template <typename Achievable>
  void markMinimal(Achievable&& achievable) {
    for (Conflict& conflict : conflicts_) {
      if (!conflict.proven || conflict.minimal) continue;
      conflict.minimal = true;
      for (const std::size_t candidate : members(conflict.members)) {
        CandidateSet without = conflict.members;
        conflict.minimal = conflict.minimal && achievable(without.reset(candidate));
      }
    }
  }

  const std::vector<Conflict>& all() const { return conflicts_; }

 private:
  std::vector<Conflict> conflicts_;
};

}  // namespace goal_alignment::achievability
