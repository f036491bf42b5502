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

void AchievedSets::addMaximal(std::vector<Achieved> maximal) {
  const std::vector<Achieved> known = std::exchange(sets_, {});
  for (Achieved& achieved : maximal) {
    const bool covered = std::any_of(known.begin(), known.end(), [&](const Achieved& old) {
      return achieved.set.is_subset_of(old.set);
    });
    if (!covered) sets_.push_back(std::move(achieved));
  }
  const std::size_t added = sets_.size();
  for (const Achieved& old : known) {
    const auto end = sets_.begin() + static_cast<std::ptrdiff_t>(added);
    const bool covered = std::any_of(sets_.begin(), end, [&](const Achieved& achieved) {
      return old.set.is_subset_of(achieved.set);
    });
    if (!covered) sets_.push_back(old);
  }
}

}  // namespace goal_alignment::achievability
