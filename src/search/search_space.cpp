// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/search_space.h"

#include <algorithm>

namespace goal_alignment::search {

SearchSpace::SearchSpace(const task::Task& task)
    : task_(task),
      registry_(task::wordsFor(task.facts.size())),
      successor_(std::max<std::size_t>(1, task::wordsFor(task.facts.size())), 0) {
  const task::State initial = task::initialState(task);
  std::copy(initial.begin(), initial.end(), successor_.begin());
  registry_.insert(successor_.data());
  ways_.push_back({kNoState, 0});
}

std::pair<StateId, bool> SearchSpace::insertSuccessor(StateId from, task::OperatorId op) {
  task::apply(task_.operators[op], registry_[from], registry_.words(), successor_.data());
  const auto inserted = registry_.insert(successor_.data());
  if (inserted.second) ways_.push_back({from, op});
  return inserted;
}

task::Plan SearchSpace::plan(StateId id) const {
  task::Plan plan;
  for (; ways_[id].parent != kNoState; id = ways_[id].parent)
    plan.push_back(ways_[id].op);
  std::reverse(plan.begin(), plan.end());
  return plan;
}

}  // namespace goal_alignment::search
