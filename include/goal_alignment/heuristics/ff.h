// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/heuristics/priority_queue.h"
#include "goal_alignment/heuristics/relaxed_task.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::heuristics {

/// The FF heuristic (Hoffmann & Nebel, JAIR 14, 2001) with h_add's supporters (Keyder & Geffner,
/// ECAI 2008): the cost of a relaxed plan. Not admissible, but infinite only where LM-cut is too.
class Ff {
 public:
  /// Throws LimitReached.
  Ff(const task::Task& task, const task::Goal& goal, const Limits& limits = {});

  /// Cost of a relaxed plan from the state, each operator counted as max(1, cost), so that plans of
  /// free operators still lead somewhere; kInfinity: proven unreachable.
  task::Cost evaluate(const task::Word* state);

  /// The operators of the last relaxed plan that can be applied in its state ("helpful actions").
  const std::vector<task::OperatorId>& preferred() const { return preferred_; }

 private:
  void explore(const task::Word* state);
  task::Cost extract(const task::Word* state);

  const task::Task& task_;
  RelaxedTask relaxed_;
  std::size_t state_words_;
  std::vector<task::Cost> fact_cost_;          // h_add
  std::vector<std::uint32_t> fact_supporter_;  // the operator that first made it so cheap
  std::vector<task::Cost> operator_cost_;      // sum of the preconditions' h_add and its own cost
  std::vector<task::Cost> fresh_operator_cost_;
  std::vector<std::uint32_t> unsatisfied_;
  std::vector<std::uint32_t> fresh_unsatisfied_;
  std::vector<bool> in_relaxed_plan_;
  std::vector<std::uint32_t> relaxed_plan_;
  std::vector<task::FactId> open_;
  std::vector<bool> marked_;
  std::vector<task::FactId> marked_facts_;
  std::vector<task::OperatorId> preferred_;
  PriorityQueue queue_;
};

}  // namespace goal_alignment::heuristics
