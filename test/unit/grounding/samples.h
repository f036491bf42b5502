// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/grounding/grounder.h"
#include "oracles/lifted_space.h"

/// What the tests of `grounding` share: a grounded task told in names, so that it can be compared.
namespace goal_alignment::grounding::samples {

struct NamedOperator {
  std::set<Literal> precondition;
  std::set<Literal> add;
  std::set<Literal> del;
  task::Cost cost = 1;

  friend bool operator==(const NamedOperator& a, const NamedOperator& b) {
    return a.precondition == b.precondition && a.add == b.add && a.del == b.del && a.cost == b.cost;
  }
};

inline std::set<Literal> named(const task::Task& task, const task::FactSet& facts) {
  std::set<Literal> names;
  for (const task::FactId fact : facts)
    names.insert(task.facts.at(fact));
  return names;
}

inline std::map<GroundName, NamedOperator> namedOperators(const task::Task& task) {
  std::map<GroundName, NamedOperator> result;
  for (const task::Operator& op : task.operators) {
    result[op.name] = {named(task, op.precondition), named(task, op.add), named(task, op.del),
                       op.cost};
  }
  return result;
}

/// The status of the literal is what a state says, for every state in `states`.
inline bool sound(const GroundTask& ground, const Literal& literal,
                  const std::vector<oracles::Atoms>& states) {
  const FactStatus status = ground.status(literal);
  for (const oracles::Atoms& atoms : states) {
    const bool holds = oracles::holds({literal}, atoms);
    if (status.kind == FactStatus::Kind::AlwaysTrue && !holds) return false;
    if (status.kind == FactStatus::Kind::NeverTrue && holds) return false;
    if (status.kind == FactStatus::Kind::Unknown && holds) return false;
  }
  return status.kind != FactStatus::Kind::Variable || ground.task.facts.at(status.fact) == literal;
}

}  // namespace goal_alignment::grounding::samples
