// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/mutexes.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::achievability {

/// Proves from a part of the task that a goal can't be had, where the whole task is too large. A
/// part is some of the mutex groups: whatever else operators and the goal ask for is taken as
/// given, so that a part can do whatever the task can. It begins with the groups of `first` and
/// grows by one group each time its plan fails in the whole task, at the fact that was missing
/// (counterexample-guided: Rovner, Sievers & Helmert, "Counterexample-Guided Abstraction Refinement
/// for Pattern Selection in Optimal Classical Planning", ICAPS 2019). So specified goals that have
/// nothing to do with it, and what they need, stay out.
///
/// Solved: the plan is one of the whole task. Unsolvable is proven. `limits.states` is for all
/// parts together; each that is too large for a fraction of them is tried once as a decision
/// diagram.
search::Result searchInParts(const search::SearchTask& task, const heuristics::MutexTable& mutexes,
                             const task::Goal& goal, const task::FactSet& first,
                             const Limits& limits);

}  // namespace goal_alignment::achievability
