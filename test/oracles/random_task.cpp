// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/random_task.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "oracles/seeds.h"

namespace goal_alignment::oracles {

using task::FactId;
using task::FactSet;

namespace {

FactSet draw(RandomSource& random, std::size_t facts, std::size_t least, std::size_t most) {
  std::vector<FactId> drawn;
  for (std::size_t n = between(random, least, most); n > 0; --n) {
    drawn.push_back(static_cast<FactId>(random.below(facts)));
  }
  return task::makeFactSet(std::move(drawn));
}

}  // namespace

task::Task randomTask(RandomSource& random, const TaskSize& size) {
  task::Task task;
  const std::size_t facts = between(random, size.least_facts, size.most_facts);
  for (std::size_t fact = 0; fact < facts; ++fact) {
    task.facts.push_back({{"f" + std::to_string(fact), {}}, false});
  }
  task.initial = draw(random, facts, 1, 4);
  const std::size_t operators = between(random, size.least_operators, size.most_operators);
  for (std::size_t i = 0; i < operators; ++i) {
    task::Operator op;
    op.name.name = "o" + std::to_string(i);
    op.precondition = draw(random, facts, chance(random, 0.1) ? 0 : 1, chance(random, 0.7) ? 2 : 3);
    op.add = draw(random, facts, 1, 2);
    const FactSet deleted = draw(random, facts, 0, 2);
    std::set_difference(deleted.begin(), deleted.end(), op.add.begin(), op.add.end(),
                        std::back_inserter(op.del));
    op.cost = size.least_cost + static_cast<task::Cost>(random.below(static_cast<std::size_t>(
                                    size.most_cost - size.least_cost + 1)));
    for (std::size_t n = size.conditional && chance(random, 0.3) ? between(random, 1, 3) : 0; n > 0;
         --n) {
      op.conditional.push_back(
          {draw(random, facts, 0, 2), draw(random, facts, 0, 2), draw(random, facts, 0, 2)});
    }
    task.operators.push_back(std::move(op));
  }
  return task;
}

task::Goal randomAlternatives(RandomSource& random, const task::Task& task) {
  task::Goal goal;
  for (std::size_t n = between(random, 1, 3); n > 0; --n)
    goal.alternatives.push_back(randomGoal(random, task));
  return goal;
}

FactSet randomGoal(RandomSource& random, const task::Task& task) {
  for (;;) {
    FactSet goal = draw(random, task.facts.size(), 1, chance(random, 0.7) ? 2 : 3);
    const bool holds =
        std::includes(task.initial.begin(), task.initial.end(), goal.begin(), goal.end());
    if (!holds || chance(random, 0.1)) return goal;
  }
}

}  // namespace goal_alignment::oracles
