// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/task/task.h"
#include "oracles/state_space.h"

/// What the tests of `search` share.
namespace goal_alignment::search::samples {

/// `bits` switches that can be flipped at will: 2^bits reachable states. Fact 2i: switch i is off,
/// fact 2i + 1: it is on.
inline task::Task switches(std::size_t bits) {
  task::Task task;
  task.facts.resize(2 * bits);
  for (task::FactId i = 0; i < bits; ++i) {
    const task::FactId off = 2 * i;
    const task::FactId on = 2 * i + 1;
    task.operators.push_back({{"on", {std::to_string(i)}}, {off}, {on}, {off}, 1});
    task.operators.push_back({{"off", {std::to_string(i)}}, {on}, {off}, {on}, 1});
    task.initial.push_back(off);
  }
  return task;
}

/// A goal that the delete relaxation believes in, and that nothing reaches: both ends of a switch.
inline task::FactSet impossible() {
  return {0, 1};
}

/// The same, to which every switch is relevant.
inline task::FactSet allOnAndOneOff(std::size_t bits) {
  task::FactSet goal = {0};
  for (task::FactId i = 0; i < bits; ++i)
    goal.push_back(2 * i + 1);
  return goal;
}

/// The task with states packed by the mutex groups that h² finds.
inline std::unique_ptr<SearchTask> packed(const task::Task& task) {
  const heuristics::MutexTable mutexes(task, {});
  return std::make_unique<SearchTask>(task, heuristics::mutexGroups(task, mutexes, {}));
}

/// The result's plan runs, satisfies the goal and costs what the result says.
inline bool valid(const task::Task& task, const task::Goal& goal, const Result& result) {
  const auto end = oracles::execute(task, result.plan);
  return end && oracles::holds(goal, *end) && task::cost(task, result.plan) == result.cost;
}

}  // namespace goal_alignment::search::samples
