// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/relaxed_task.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// What is known of an optimal plan's cost beforehand.
struct Bounds {
  task::Cost lower = 0;                      ///< no plan costs less
  task::Cost upper = heuristics::kInfinity;  ///< plans that cost as much are of no interest
};

/// A* with incremental LM-cut on the part of the task that is relevant to the goal. Solved: the
/// plan is optimal. Reopens, since LM-cut is inconsistent; ties are broken by the smaller h, then
/// by the later arrival.
///
/// A successor is first given the bound that its parent's landmarks imply, and LM-cut is computed
/// only when the state is the next to be expanded: most states never are. A goal state bounds the
/// search as soon as it is generated.
///
/// Only what lies within the bounds is of interest: where `upper` says that plans cost as much or
/// more, Unsolvable means that no cheaper one exists. Deterministic for given limits in states and
/// bytes. Statistics count an evaluation each time LM-cut is computed.
Result astar(const SearchTask& task, const task::Goal& goal, const Limits& limits,
             const Bounds& bounds = {});

}  // namespace goal_alignment::search
