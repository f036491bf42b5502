// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/state_space.h"

#include <utility>

namespace goal_alignment::oracles {

using task::Cost;
using task::FactId;
using task::OperatorId;

Facts initialFacts(const task::Task& task) {
  return {task.initial.begin(), task.initial.end()};
}

Facts factsOf(const task::Task& task, const task::Word* state) {
  Facts facts;
  for (FactId fact = 0; fact < task.facts.size(); ++fact) {
    if (((state[fact / 64] >> (fact % 64)) & 1U) != 0) facts.insert(fact);
  }
  return facts;
}

task::State stateOf(const task::Task& task, const Facts& facts) {
  task::State state(task.facts.size() / 64 + 1, 0);
  for (const FactId fact : facts)
    state[fact / 64] |= task::Word{1} << (fact % 64);
  return state;
}

bool holds(const task::FactSet& goal, const Facts& facts) {
  for (const FactId fact : goal) {
    if (facts.count(fact) == 0) return false;
  }
  return true;
}

bool holds(const task::Goal& goal, const Facts& facts) {
  for (const task::FactSet& alternative : goal.alternatives) {
    if (holds(alternative, facts)) return true;
  }
  return false;
}

Facts successor(const task::Operator& op, const Facts& facts) {
  Facts added(op.add.begin(), op.add.end());
  Facts deleted(op.del.begin(), op.del.end());
  for (const task::ConditionalEffect& effect : op.conditional) {
    if (!holds(effect.condition, facts)) continue;
    added.insert(effect.add.begin(), effect.add.end());
    deleted.insert(effect.del.begin(), effect.del.end());
  }
  Facts after = facts;
  for (const FactId fact : deleted)
    after.erase(fact);
  after.insert(added.begin(), added.end());
  return after;
}

std::vector<OperatorId> applicableOperators(const task::Task& task, const Facts& facts) {
  std::vector<OperatorId> applicable;
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    if (holds(task.operators[op].precondition, facts)) applicable.push_back(op);
  }
  return applicable;
}

std::map<Facts, Cost> reachable(const task::Task& task, const Facts& from) {
  std::map<Facts, Cost> settled;
  std::set<std::pair<Cost, Facts>> open = {{0, from}};
  while (!open.empty()) {
    const auto [cost, facts] = *open.begin();
    open.erase(open.begin());
    if (!settled.emplace(facts, cost).second) continue;
    for (const OperatorId op : applicableOperators(task, facts)) {
      open.emplace(cost + task.operators[op].cost, successor(task.operators[op], facts));
    }
  }
  return settled;
}

std::optional<Cost> optimalCost(const task::Task& task, const Facts& from, const task::Goal& goal) {
  std::optional<Cost> best;
  for (const auto& [facts, cost] : reachable(task, from)) {
    if (holds(goal, facts) && (!best || cost < *best)) best = cost;
  }
  return best;
}

std::optional<Facts> execute(const task::Task& task, const task::Plan& plan) {
  Facts facts = initialFacts(task);
  for (const OperatorId op : plan) {
    if (!holds(task.operators.at(op).precondition, facts)) return std::nullopt;
    facts = successor(task.operators[op], facts);
  }
  return facts;
}

}  // namespace goal_alignment::oracles
