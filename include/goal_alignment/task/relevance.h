// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::task {

/// What may matter for a goal, by backward reachability: the goal's facts; operators that add a
/// fact that matters; the facts these need, those in the conditions of their effects included; and
/// operators that delete a fact in the condition of a delete.
struct Relevance {
  std::vector<bool> facts;
  std::vector<bool> operators;
};

/// O(size of the task). Throws LimitReached.
Relevance relevance(const Task& task, const Goal& goal, const Limits& limits = {});

/// A task without what can't matter for its one goal. Optimal plans of the two are the same, but
/// for operators of which the larger task has several that do the same here.
struct Projection {
  Task task;
  Goal goal;
  std::vector<FactId> facts;       ///< the fact in the task that was projected
  std::vector<OperatorId> origin;  ///< the operator there

  /// The plan in terms of that task.
  Plan original(const Plan& plan) const;
};

/// Drops irrelevant facts and operators and, of operators that do the same, all but the first of
/// the cheapest. Operators carry no names, which only the original needs. O(size of the task ·
/// log). Throws LimitReached.
Projection project(const Task& task, const Goal& goal, const Limits& limits = {});

}  // namespace goal_alignment::task
