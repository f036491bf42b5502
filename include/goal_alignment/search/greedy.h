// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// Lazy greedy best-first search with FF and preferred operators in a second open list that is
/// boosted at every progress (Richter & Helmert, "Preferred Operators and Deferred Evaluation in
/// Satisficing Planning", ICAPS 2009). Complete: Unsolvable is proven. The plan is any plan.
Result greedy(const SearchTask& task, const task::Goal& goal, const Limits& limits);

/// The same with g + weight · h in place of h, reopening: lazy weighted A*. Plans that cost
/// `upper_bound` or more are of no interest; Unsolvable means that no cheaper one exists.
Result weighted(const SearchTask& task, const task::Goal& goal, const Limits& limits,
                task::Cost weight, task::Cost upper_bound);

}  // namespace goal_alignment::search
