// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/search_space.h"

#include <algorithm>

namespace goal_alignment::search {

SearchSpace::SearchSpace(const SearchTask& task)
    : task_(task),
      registry_(task.packing().words()),
      facts_(task::initialState(task.task())),
      successor_(registry_.words(), 0) {
  task_.packing().pack(facts_.data(), successor_.data());
  registry_.insert(successor_.data());
  ways_.push_back({kNoState, 0});
}

std::pair<StateId, bool> SearchSpace::insertSuccessor(StateId from, task::OperatorId op) {
  task_.packing().apply(op, registry_[from], successor_.data());
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
