// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/relaxed_task.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/search/successor_generator.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// A* with LM-cut, reopening (LM-cut is inconsistent), ties broken by the smaller h, then by the
/// later arrival. Solved: the plan is optimal.
///
/// `upper_bound`: plans that cost as much or more are of no interest; Unsolvable then means that no
/// cheaper one exists. Deterministic for given limits in states and bytes.
Result astar(const task::Task& task, const SuccessorGenerator& successors,
             const task::FactSet& goal, const Limits& limits,
             task::Cost upper_bound = heuristics::kInfinity);

}  // namespace goal_alignment::search
