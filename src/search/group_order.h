// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "events.h"

namespace goal_alignment::search {

/// Groups in the order of their levels, root first.
using GroupOrder = std::vector<std::uint32_t>;

/// Orders worth a try; which is best shows only in trying. First, groups that events touch together
/// stand close to each other (Aloul, Markov & Sakallah, "FORCE: A Fast and Easy-To-Implement
/// Variable-Ordering Heuristic", GLSVLSI 2003): best for vehicles and what they carry. Then, groups
/// that most others interact with stand first: best where those fill up, as holes and blocks do.
std::vector<GroupOrder> groupOrders(std::size_t groups, const std::vector<Event>& events);

}  // namespace goal_alignment::search
