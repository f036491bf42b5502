// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// Values this close are one value: they are sums of the same products in another order.
constexpr double kTolerance = 1e-11;

/// For policies that ask inside conflicts only: the open members of every live conflict, by the
/// index of the conflict. Nothing where the dialogue has ended: every conflict is hit by a NO, or
/// one that is not has no open member left.
struct LiveConflict {
  std::size_t conflict = 0;
  std::vector<std::size_t> open;
};
std::vector<LiveConflict> liveConflicts(const Situation& situation);

/// One of several candidates that are equally good to ask: one whose reason is proven where there
/// is one, by chance among those.
Choice anyOf(const std::vector<std::size_t>& candidates, const Situation& situation,
             RandomSource& random);

}  // namespace goal_alignment::questions
