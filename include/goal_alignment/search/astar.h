// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/relaxed_task.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// A* with incremental LM-cut on the part of the task that is relevant to the goal. Solved: the
/// plan is optimal. Reopens, since LM-cut is inconsistent; ties are broken by the smaller h, then
/// by the later arrival.
///
/// A successor is first given the bound that its parent's landmarks imply, and LM-cut is computed
/// only when the state is the next to be expanded: most states never are. A goal state bounds the
/// search as soon as it is generated.
///
/// `upper_bound`: plans that cost as much or more are of no interest; Unsolvable then means that no
/// cheaper one exists. Deterministic for given limits in states and bytes. Statistics count an
/// evaluation each time LM-cut is computed.
Result astar(const task::Task& task, const task::Goal& goal, const Limits& limits,
             task::Cost upper_bound = heuristics::kInfinity);

}  // namespace goal_alignment::search
