// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/solve.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/heuristics/mutexes.h"
#include "goal_alignment/search/astar.h"
#include "goal_alignment/search/greedy.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/search/symbolic.h"

namespace goal_alignment::search {

namespace {

/// Generated states before the proof is tried: what needs more is hard enough for it to pay.
constexpr std::uint64_t kFirstStates = 1'000'000;
/// Steps on diagrams: some seconds.
constexpr std::uint64_t kProofSteps = 20'000'000;

Result search(const SearchTask& task, const task::Goal& goal, Seek seek, const Limits& limits) {
  return seek == Seek::OptimalPlan ? astar(task, goal, limits) : greedy(task, goal, limits);
}

/// Half of the memory is left to the search that goes on where this proves nothing.
bool provenUnsolvable(const SearchTask& task, const task::Goal& goal, const Limits& limits) {
  Symbolic symbolic(task.task(), task.groups());
  Limits own = limits.withStates(std::min(limits.states, kProofSteps));
  own.bytes = limits.bytes / 2;
  return symbolic.run(own) == LimitReason::None && !symbolic.reachable(goal);
}

/// The plan in terms of the task that still had its inapplicable operators.
task::Plan original(task::Plan plan, const heuristics::MutexTable& mutexes, std::size_t operators) {
  std::vector<task::OperatorId> kept;
  for (task::OperatorId op = 0; op < operators; ++op) {
    if (mutexes.applicable(op)) kept.push_back(op);
  }
  for (task::OperatorId& op : plan)
    op = kept[op];
  return plan;
}

}  // namespace

Result solve(const task::Task& task, const task::Goal& goal, Seek seek, const Limits& limits) {
  const auto began = Limits::Clock::now();
  Result result;
  result.status = Status::Unsolvable;
  if (goal.alternatives.empty()) return result;
  const heuristics::MutexTable mutexes(task, limits);
  if (mutexes.rulesOut(goal)) return result;
  const SearchTask ready(mutexes.withoutInapplicable(task),
                         heuristics::mutexGroups(task, mutexes, limits), limits);
  const std::chrono::duration<double> preparing = Limits::Clock::now() - began;
  result = search(ready, goal, seek, limits.withStates(std::min(limits.states, kFirstStates)));
  if (result.limit == LimitReason::States && limits.states > kFirstStates) {
    if (provenUnsolvable(ready, goal, limits)) {
      result.status = Status::Unsolvable;
      result.limit = LimitReason::None;
    } else {
      const Statistics first = result.statistics;
      result = search(ready, goal, seek, limits);
      result.statistics.expanded += first.expanded;
      result.statistics.evaluated += first.evaluated;
      result.statistics.generated += first.generated;
    }
  }
  result.plan = original(std::move(result.plan), mutexes, task.operators.size());
  result.statistics.preparing = preparing.count();
  return result;
}

}  // namespace goal_alignment::search
