// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::achievability {

/// The maximal sets of candidates known to be achievable together with the specified goal, each
/// with a plan.
class AchievedSets {
 public:
  struct Achieved {
    CandidateSet set;
    task::Plan plan;
  };

  /// A known set that contains this one, or null. O(sets · candidates / 64).
  const Achieved* covering(const CandidateSet& set) const;

  /// Adds the set unless it is covered, and drops the sets that it covers. O(sets · candidates /
  /// 64).
  void add(const CandidateSet& set, task::Plan plan);

  /// Adds many sets, none of which covers another. O(old sets · new sets), where calling add() for
  /// each would be quadratic in the new ones.
  void addMaximal(std::vector<Achieved> maximal);

  const std::vector<Achieved>& all() const { return sets_; }

 private:
  std::vector<Achieved> sets_;
};

}  // namespace goal_alignment::achievability
