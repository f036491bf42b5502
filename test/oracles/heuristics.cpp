// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/heuristics.h"

#include <algorithm>
#include <map>

namespace goal_alignment::oracles {

using task::Cost;
using task::FactId;
using task::FactSet;
using task::Operator;

std::optional<Cost> hMax(const task::Task& task, const Facts& state, const FactSet& goal) {
  std::map<FactId, Cost> cost;
  for (const FactId fact : state)
    cost[fact] = 0;
  const auto dearest = [&cost](const FactSet& facts) -> std::optional<Cost> {
    Cost most = 0;
    for (const FactId fact : facts) {
      if (cost.count(fact) == 0) return std::nullopt;
      most = std::max(most, cost[fact]);
    }
    return most;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (const Operator& op : task.operators) {
      const auto reach = [&](FactSet condition, const FactSet& added) {
        condition.insert(condition.end(), op.precondition.begin(), op.precondition.end());
        const auto before = dearest(condition);
        for (const FactId fact : added) {
          if (!before || (cost.count(fact) > 0 && cost[fact] <= *before + op.cost)) continue;
          cost[fact] = *before + op.cost;
          changed = true;
        }
      };
      reach({}, op.add);
      for (const task::ConditionalEffect& effect : op.conditional)
        reach(effect.condition, effect.add);
    }
  }
  return dearest(goal);
}

namespace {

Pair makePair(FactId f, FactId g) {
  return {std::min(f, g), std::max(f, g)};
}

bool allPossible(const std::set<Pair>& possible, const FactSet& facts) {
  for (const FactId f : facts) {
    for (const FactId g : facts) {
      if (possible.count(makePair(f, g)) == 0) return false;
    }
  }
  return true;
}

bool has(const FactSet& facts, FactId fact) {
  return std::find(facts.begin(), facts.end(), fact) != facts.end();
}

/// Whether the operator can make both true: it adds one, and adds the other or leaves it true.
bool achieves(const std::set<Pair>& possible, const Operator& op, FactId f, FactId g) {
  if (has(op.add, f) && has(op.add, g)) return allPossible(possible, op.precondition);
  if (!has(op.add, f) || has(op.del, g)) return false;
  FactSet before = op.precondition;
  before.push_back(g);
  return allPossible(possible, before);
}

}  // namespace

std::set<Pair> possiblePairs(const task::Task& task) {
  std::set<Pair> possible;
  for (const FactId f : task.initial) {
    for (const FactId g : task.initial)
      possible.insert(makePair(f, g));
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const Operator& op : task.operators) {
      for (FactId f = 0; f < task.facts.size(); ++f) {
        for (FactId g = 0; g < task.facts.size(); ++g) {
          if (possible.count(makePair(f, g)) > 0 || !achieves(possible, op, f, g)) continue;
          possible.insert(makePair(f, g));
          changed = true;
        }
      }
    }
  }
  return possible;
}

std::set<Pair> reachablePairs(const task::Task& task) {
  std::set<Pair> pairs;
  for (const auto& [facts, cost] : reachable(task, initialFacts(task))) {
    for (const FactId f : facts) {
      for (const FactId g : facts)
        pairs.insert(makePair(f, g));
    }
  }
  return pairs;
}

}  // namespace goal_alignment::oracles
