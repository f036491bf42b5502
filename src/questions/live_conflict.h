// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// Values this close count as equal: they are sums of the same products in another order.
constexpr double kTolerance = 1e-11;

/// A conflict that no NO has hit, and its members that nobody has answered yet.
struct LiveConflict {
  std::size_t conflict = 0;  ///< index in Situation::conflicts
  std::vector<std::size_t> open;
};

/// For policies that only ask inside conflicts: every live conflict. Empty where the dialogue has
/// ended: every conflict is hit by a NO, or one that is not has no open member left.
std::vector<LiveConflict> liveConflicts(const Situation& situation);

/// Chooses one of several candidates that are equally good to ask, at random among those whose
/// reason is proven, or among all where no reason is. `candidates` must not be empty.
Choice chooseAmong(const std::vector<std::size_t>& candidates, const Situation& situation,
                   RandomSource& random);

}  // namespace goal_alignment::questions
