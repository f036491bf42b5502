// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/search/successor_generator.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// Lazy greedy best-first search with FF and preferred operators in a second open list that is
/// boosted at every progress (Richter & Helmert, "Preferred Operators and Deferred Evaluation in
/// Satisficing Planning", ICAPS 2009). Complete: Unsolvable is proven. The plan is any plan.
Result greedy(const task::Task& task, const SuccessorGenerator& successors, const task::Goal& goal,
              const Limits& limits);

}  // namespace goal_alignment::search
