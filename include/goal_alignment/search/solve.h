// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// What a single planning call is after.
enum class Seek : std::uint8_t { AnyPlan, OptimalPlan };

/// One goal of one task, from its mutexes to a plan or the proof that there is none: greedy search
/// or A*, and between a first, short run and the full one a look at all reachable states as a
/// diagram, which proves what a search for a plan never would. Throws LimitReached while preparing.
/// Statistics add up both searches.
Result solve(const task::Task& task, const task::Goal& goal, Seek seek, const Limits& limits);

}  // namespace goal_alignment::search
