// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/task/task.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "goal_alignment/common/free_elsewhere.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::task {

Task::~Task() {
  constexpr std::size_t kSoonFreed = 50'000;
  if (facts.size() + operators.size() <= kSoonFreed) return;
  freeElsewhere(std::make_pair(std::move(facts), std::move(operators)));
}

Cost cost(const Task& task, const Plan& plan) {
  Cost total = 0;
  for (const OperatorId op : plan)
    total += task.operators[op].cost;
  return total;
}

std::vector<GroundName> names(const Task& task, const Plan& plan) {
  std::vector<GroundName> result;
  result.reserve(plan.size());
  for (const OperatorId op : plan)
    result.push_back(task.operators[op].name);
  return result;
}

FactSet makeFactSet(std::vector<FactId> facts) {
  std::sort(facts.begin(), facts.end());
  facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
  return facts;
}

FactSet unite(const FactSet& one, const FactSet& other) {
  FactSet either;
  either.reserve(one.size() + other.size());
  std::set_union(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(either));
  return either;
}

bool has(const FactSet& set, FactId fact) {
  return std::binary_search(set.begin(), set.end(), fact);
}

Goal withFacts(Goal goal, std::vector<FactId> facts) {
  const FactSet more = makeFactSet(std::move(facts));
  for (FactSet& alternative : goal.alternatives)
    alternative = unite(alternative, more);
  return goal;
}

State initialState(const Task& task) {
  State state(wordsFor(task.facts.size()), 0);
  for (const FactId fact : task.initial)
    setBit(state.data(), fact);
  return state;
}

}  // namespace goal_alignment::task
