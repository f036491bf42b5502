// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"

namespace goal_alignment::achievability {

/// The known conflicts. None is a superset of another proven one, and no suspected one is a
/// superset of another suspected one.
class ConflictSet {
 public:
  /// Adds a conflict that says something new and drops those that it makes superfluous. Returns
  /// whether it was added.
  /// O(conflicts · candidates / 64).
  bool add(const Conflict& conflict);

  /// A proven conflict within the set, or null.
  const Conflict* provenWithin(const CandidateSet& set) const;

  /// Removes the suspected conflicts within a set that turned out to be achievable. Returns whether
  /// there was any.
  bool clearSuspectedWithin(const CandidateSet& achievable);

  /// Marks proven conflicts as minimal where `achievable(set)` says so of each set with one member
  /// less.
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
