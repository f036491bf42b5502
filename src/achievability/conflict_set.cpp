// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/conflict_set.h"

#include <algorithm>

namespace goal_alignment::achievability {

bool ConflictSet::add(const Conflict& conflict) {
  for (Conflict& known : conflicts_) {
    if (known.members == conflict.members && (known.proven || !conflict.proven)) {
      known.minimal = known.minimal || (conflict.minimal && conflict.proven);
      return false;
    }
    if (known.proven && known.members.is_subset_of(conflict.members)) return false;
  }
  if (conflict.proven) {
    const auto superfluous = std::remove_if(
        conflicts_.begin(), conflicts_.end(),
        [&](const Conflict& known) { return conflict.members.is_subset_of(known.members); });
    if (superfluous != conflicts_.end()) hitting_sets_valid_ = false;
    conflicts_.erase(superfluous, conflicts_.end());
  }
  conflicts_.push_back(conflict);
  return true;
}

const Conflict* ConflictSet::provenWithin(const CandidateSet& set) const {
  for (const Conflict& conflict : conflicts_) {
    if (conflict.proven && conflict.members.is_subset_of(set)) return &conflict;
  }
  return nullptr;
}

void ConflictSet::clearSuspectedWithin(const CandidateSet& achievable) {
  const auto wrong =
      std::remove_if(conflicts_.begin(), conflicts_.end(), [&](const Conflict& known) {
        return !known.proven && known.members.is_subset_of(achievable);
      });
  if (wrong != conflicts_.end()) hitting_sets_valid_ = false;
  conflicts_.erase(wrong, conflicts_.end());
}

void ConflictSet::markMinimal() {
  for (Conflict& conflict : conflicts_)
    conflict.minimal = true;
}

namespace {

/// Berge's step: from the minimal sets that hit some conflicts to those that hit one more.
std::vector<CandidateSet> hitOneMore(const std::vector<CandidateSet>& hitting,
                                     const CandidateSet& conflict) {
  std::vector<CandidateSet> result;
  std::vector<const CandidateSet*> missing;
  for (const CandidateSet& set : hitting) {
    if (set.intersects(conflict)) {
      result.push_back(set);
    } else {
      missing.push_back(&set);
    }
  }
  const std::size_t kept = result.size();
  for (const CandidateSet* set : missing) {
    for (const std::size_t candidate : members(conflict)) {
      CandidateSet larger = *set;
      larger.set(candidate);
      const bool minimal =
          std::none_of(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(kept),
                       [&](const CandidateSet& other) { return other.is_subset_of(larger); });
      if (minimal) result.push_back(std::move(larger));
    }
  }
  return result;
}

}  // namespace

const std::vector<CandidateSet>* ConflictSet::minimalHittingSets(std::size_t most) {
  if (!hitting_sets_valid_) {
    hitting_sets_.assign(1, CandidateSet(candidates_));
    hit_count_ = 0;
    hitting_sets_valid_ = true;
  }
  for (; hit_count_ < conflicts_.size(); ++hit_count_) {
    if (hitting_sets_.size() > most) return nullptr;
    hitting_sets_ = hitOneMore(hitting_sets_, conflicts_[hit_count_].members);
  }
  return hitting_sets_.size() > most ? nullptr : &hitting_sets_;
}

}  // namespace goal_alignment::achievability
