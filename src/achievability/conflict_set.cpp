// SPDX-License-Identifier: BSD-3-Clause
#include "conflict_set.h"

#include <algorithm>

namespace goal_alignment::achievability {

bool ConflictSet::add(const Conflict& conflict) {
  for (Conflict& known : conflicts_) {
    const bool says_as_much = known.proven || !conflict.proven;
    if (!says_as_much || !known.members.is_subset_of(conflict.members)) continue;
    if (known.members == conflict.members && conflict.proven) known.minimal |= conflict.minimal;
    return false;
  }
  const auto superfluous =
      std::remove_if(conflicts_.begin(), conflicts_.end(), [&](const Conflict& known) {
        return (conflict.proven || !known.proven) && conflict.members.is_subset_of(known.members);
      });
  conflicts_.erase(superfluous, conflicts_.end());
  conflicts_.push_back(conflict);
  return true;
}

const Conflict* ConflictSet::provenWithin(const CandidateSet& set) const {
  for (const Conflict& conflict : conflicts_) {
    if (conflict.proven && conflict.members.is_subset_of(set)) return &conflict;
  }
  return nullptr;
}

bool ConflictSet::clearSuspectedWithin(const CandidateSet& achievable) {
  const std::size_t before = conflicts_.size();
  conflicts_.erase(std::remove_if(conflicts_.begin(), conflicts_.end(),
                                  [&](const Conflict& known) {
                                    return !known.proven && known.members.is_subset_of(achievable);
                                  }),
                   conflicts_.end());
  return conflicts_.size() != before;
}

}  // namespace goal_alignment::achievability
