// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::achievability {

/// The largest sets of candidates known to be had together with the specified goal, each with a
/// plan.
class AchievedSets {
 public:
  struct Achieved {
    CandidateSet set;
    task::Plan plan;
  };

  /// Whether a set at least as large is known. O(sets · candidates / 64).
  const Achieved* covering(const CandidateSet& set) const;

  /// Adds the set unless it is covered, and drops those it covers.
  void add(const CandidateSet& set, task::Plan plan);

  /// The same for many, none of which covers another. O(old sets · new sets), where add() for each
  /// would be quadratic in the new ones.
  void addMaximal(std::vector<Achieved> maximal);

  const std::vector<Achieved>& all() const { return sets_; }

 private:
  std::vector<Achieved> sets_;
};

}  // namespace goal_alignment::achievability
