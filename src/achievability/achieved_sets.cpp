// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/achieved_sets.h"

#include <algorithm>
#include <utility>

namespace goal_alignment::achievability {

const AchievedSets::Achieved* AchievedSets::covering(const CandidateSet& set) const {
  const auto found = std::find_if(sets_.begin(), sets_.end(), [&](const Achieved& achieved) {
    return set.is_subset_of(achieved.set);
  });
  return found == sets_.end() ? nullptr : &*found;
}

void AchievedSets::add(const CandidateSet& set, task::Plan plan) {
  if (covering(set) != nullptr) return;
  sets_.erase(
      std::remove_if(sets_.begin(), sets_.end(),
                     [&](const Achieved& achieved) { return achieved.set.is_subset_of(set); }),
      sets_.end());
  sets_.push_back({set, std::move(plan)});
}

}  // namespace goal_alignment::achievability
