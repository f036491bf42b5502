// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "events.h"
#include "goal_alignment/common/limits.h"

namespace goal_alignment::search {

/// Groups in the order of their levels, root first.
using GroupOrder = std::vector<std::uint32_t>;

/// Orders worth a try; which is best shows only in trying, by factors of a hundred either way.
/// First, groups that events touch together stand close to each other (Aloul, Markov & Sakallah,
/// "FORCE: A Fast and Easy-To-Implement Variable-Ordering Heuristic", GLSVLSI 2003): best for
/// chains of causes. Then, groups that many others interact with stand last, best for lifts and
/// what they carry; and first, best where every other group is one that fills up: holes, blocks,
/// fuel.
/// Throws LimitReached.
std::vector<GroupOrder> groupOrders(std::size_t groups, const std::vector<Event>& events,
                                    const Limits& limits);

}  // namespace goal_alignment::search
