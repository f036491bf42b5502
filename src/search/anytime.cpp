// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/anytime.h"

#include <algorithm>
#include <utility>

#include "goal_alignment/search/astar.h"
#include "goal_alignment/search/greedy.h"

namespace goal_alignment::search {

namespace {

constexpr task::Cost kWeights[] = {5, 3, 2, 1};

/// A restart that finds nothing for so long leaves the rest of the time to the next one.
constexpr std::uint64_t kMaxStates = 500'000;

bool isFinal(LimitReason reason) {
  return reason == LimitReason::Time || reason == LimitReason::Cancelled;
}

}  // namespace

Improved improve(const SearchTask& task, const task::Goal& goal, task::Plan plan,
                 const Limits& limits) {
  Improved best;
  best.cost = task::cost(task.task(), plan);
  best.plan = std::move(plan);
  const auto take = [&best](Result result) {
    best.limit = result.limit;
    if (result.status != Status::Solved) return false;
    best.plan = std::move(result.plan);
    best.cost = result.cost;
    return true;
  };
  const Limits each = limits.withStates(std::min(limits.states, kMaxStates));
  for (const task::Cost weight : kWeights) {
    while (take(weighted(task, goal, each, weight, best.cost))) {
    }
    if (isFinal(best.limit)) return best;
    best.optimal = best.limit == LimitReason::None;
    if (best.optimal) return best;  // nothing cheaper exists
  }
  Result last = astar(task, goal, limits, {0, best.cost});
  best.optimal = last.status != Status::LimitReached;
  take(std::move(last));
  return best;
}

}  // namespace goal_alignment::search
