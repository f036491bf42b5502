// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/conditional_task.h"

#include <utility>
#include <vector>

#include "oracles/seeds.h"

namespace goal_alignment::oracles {

using task::FactId;

task::Task randomConditionalTask(RandomSource& random, const TaskSize& size) {
  task::Task task = randomTask(random, size);
  const auto draw = [&](std::size_t least, std::size_t most) {
    std::vector<FactId> facts;
    for (std::size_t n = between(random, least, most); n > 0; --n)
      facts.push_back(static_cast<FactId>(random.below(task.facts.size())));
    return task::makeFactSet(std::move(facts));
  };
  for (task::Operator& op : task.operators) {
    if (chance(random, 0.5)) continue;
    for (std::size_t n = between(random, 1, 2); n > 0; --n)
      op.conditional.push_back({draw(0, 2), draw(0, 2), draw(0, 2)});
  }
  return task;
}

std::set<Facts> conditionallyReachable(const task::Task& task) {
  std::set<Facts> known = {initialFacts(task)};
  std::vector<Facts> open = {initialFacts(task)};
  while (!open.empty()) {
    const Facts before = open.back();
    open.pop_back();
    for (const task::OperatorId id : applicableOperators(task, before)) {
      const task::Operator& op = task.operators[id];
      Facts add(op.add.begin(), op.add.end());
      Facts after = before;
      const auto erase = [&](const task::FactSet& facts) {
        for (const FactId fact : facts)
          after.erase(fact);
      };
      erase(op.del);
      for (const task::ConditionalEffect& effect : op.conditional) {
        if (!holds(effect.condition, before)) continue;
        erase(effect.del);
        add.insert(effect.add.begin(), effect.add.end());
      }
      after.insert(add.begin(), add.end());
      if (known.insert(after).second) open.push_back(after);
    }
  }
  return known;
}

}  // namespace goal_alignment::oracles
