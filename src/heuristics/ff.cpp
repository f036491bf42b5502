// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/ff.h"

#include <algorithm>

namespace goal_alignment::heuristics {

using task::Cost;
using task::FactId;

namespace {

constexpr std::uint32_t kNoSupporter = static_cast<std::uint32_t>(-1);

}  // namespace

Ff::Ff(const task::Task& task, const task::Goal& goal, const Limits& limits)
    : task_(task),
      relaxed_(task, goal, limits),
      state_words_(task::wordsFor(task.facts.size())),
      fact_cost_(relaxed_.fact_count),
      fact_supporter_(relaxed_.fact_count),
      in_relaxed_plan_(relaxed_.operator_count, false),
      marked_(relaxed_.fact_count, false) {
  for (std::uint32_t op = 0; op < relaxed_.operator_count; ++op) {
    fresh_unsatisfied_.push_back(static_cast<std::uint32_t>(relaxed_.preconditions.size(op)));
    const Cost cost = std::max<Cost>(1, relaxed_.cost[op]);
    fresh_operator_cost_.push_back(op >= relaxed_.first_goal_operator ? 0 : cost);
  }
}

void Ff::explore(const task::Word* state) {
  std::fill(fact_cost_.begin(), fact_cost_.end(), kInfinity);
  operator_cost_ = fresh_operator_cost_;
  unsatisfied_ = fresh_unsatisfied_;
  queue_.clear();
  const auto reach = [this](FactId fact, Cost cost, std::uint32_t supporter) {
    if (fact_cost_[fact] <= cost) return;
    fact_cost_[fact] = cost;
    fact_supporter_[fact] = supporter;
    queue_.push(cost, fact);
  };
  task::forEachBit(state, state_words_,
                   [&](std::size_t fact) { reach(static_cast<FactId>(fact), 0, kNoSupporter); });
  reach(relaxed_.true_fact, 0, kNoSupporter);
  while (!queue_.empty()) {
    const auto [cost, fact] = queue_.pop();
    if (cost > fact_cost_[fact]) continue;
    // Everything the goal needs is settled once the goal itself is popped.
    if (fact == relaxed_.goal_fact) break;
    for (const std::uint32_t op : relaxed_.precondition_of[fact]) {
      operator_cost_[op] += cost;
      if (--unsatisfied_[op] != 0) continue;
      for (const FactId effect : relaxed_.effects[op])
        reach(effect, operator_cost_[op], op);
    }
  }
}

Cost Ff::extract(const task::Word* state) {
  relaxed_plan_.clear();
  open_.assign(1, relaxed_.goal_fact);
  while (!open_.empty()) {
    const FactId fact = open_.back();
    open_.pop_back();
    const std::uint32_t op = fact_supporter_[fact];
    if (marked_[fact] || op == kNoSupporter) continue;
    marked_[fact] = true;
    marked_facts_.push_back(fact);
    if (in_relaxed_plan_[op]) continue;
    in_relaxed_plan_[op] = true;
    relaxed_plan_.push_back(op);
    for (const FactId needed : relaxed_.preconditions[op])
      open_.push_back(needed);
  }
  Cost total = 0;
  for (const std::uint32_t op : relaxed_plan_) {
    in_relaxed_plan_[op] = false;
    total += fresh_operator_cost_[op];
    if (op >= relaxed_.first_goal_operator) continue;
    const task::OperatorId origin = relaxed_.origin[op];
    if (task::contains(state, task_.operators[origin].precondition)) preferred_.push_back(origin);
  }
  if (relaxed_.several_parts) {
    std::sort(preferred_.begin(), preferred_.end());
    preferred_.erase(std::unique(preferred_.begin(), preferred_.end()), preferred_.end());
  }
  for (const FactId fact : marked_facts_)
    marked_[fact] = false;
  marked_facts_.clear();
  return total;
}

Cost Ff::evaluate(const task::Word* state) {
  preferred_.clear();
  explore(state);
  if (fact_cost_[relaxed_.goal_fact] == kInfinity) return kInfinity;
  return extract(state);
}

}  // namespace goal_alignment::heuristics
