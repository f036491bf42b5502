// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/search_task.h"

#include <utility>
#include <vector>

namespace goal_alignment::search {

namespace {

heuristics::MutexGroups singleFacts(const task::Task& task) {
  std::vector<task::FactSet> groups;
  for (task::FactId fact = 0; fact < task.facts.size(); ++fact)
    groups.push_back({fact});
  return {task, std::move(groups)};
}

}  // namespace

SearchTask::SearchTask(task::Task task, heuristics::MutexGroups groups, const Limits& limits)
    : task_(std::move(task)),
      groups_(std::move(groups)),
      successors_(task_, limits),
      packing_(task_, groups_, limits) {}

SearchTask::SearchTask(task::Task task)
    : task_(std::move(task)),
      groups_(singleFacts(task_)),
      successors_(task_),
      packing_(task_, groups_) {}

}  // namespace goal_alignment::search
