// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/relaxed_task.h"

#include <cstddef>

namespace goal_alignment::heuristics {

using task::FactId;
using task::OperatorId;

namespace {

using RowList = std::vector<std::vector<std::uint32_t>>;

/// The operators that a delete-free plan for the goal may use, by backward reachability.
std::vector<bool> relevantOperators(const task::Task& task, const task::FactSet& goal) {
  std::vector<std::vector<OperatorId>> adders(task.facts.size());
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    for (const FactId fact : task.operators[op].add)
      adders[fact].push_back(op);
  }
  std::vector<bool> relevant(task.operators.size(), false);
  std::vector<bool> seen(task.facts.size(), false);
  std::vector<FactId> open(goal);
  for (const FactId fact : goal)
    seen[fact] = true;
  while (!open.empty()) {
    const FactId fact = open.back();
    open.pop_back();
    for (const OperatorId op : adders[fact]) {
      if (relevant[op]) continue;
      relevant[op] = true;
      for (const FactId needed : task.operators[op].precondition) {
        if (!seen[needed]) open.push_back(needed);
        seen[needed] = true;
      }
    }
  }
  return relevant;
}

RowList transposed(const RowList& rows, std::size_t columns) {
  RowList result(columns);
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    for (const std::uint32_t j : rows[i])
      result[j].push_back(i);
  }
  return result;
}

}  // namespace

Rows::Rows(const RowList& rows) {
  starts_.reserve(rows.size() + 1);
  starts_.push_back(0);
  for (const auto& row : rows) {
    values_.insert(values_.end(), row.begin(), row.end());
    starts_.push_back(static_cast<std::uint32_t>(values_.size()));
  }
}

RelaxedTask::RelaxedTask(const task::Task& task, const task::FactSet& goal)
    : fact_count(task.facts.size() + 2),
      true_fact(static_cast<FactId>(task.facts.size())),
      goal_fact(true_fact + 1) {
  const std::vector<bool> relevant = relevantOperators(task, goal);
  RowList precondition_rows;
  RowList effect_rows;
  const auto add = [&](const task::FactSet& precondition, std::vector<FactId> effect,
                       task::Cost operator_cost) {
    precondition_rows.push_back(precondition);
    if (precondition.empty()) precondition_rows.back().push_back(true_fact);
    effect_rows.push_back(std::move(effect));
    cost.push_back(operator_cost);
  };
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    if (!relevant[op]) continue;
    origin.push_back(op);
    add(task.operators[op].precondition, task.operators[op].add, task.operators[op].cost);
  }
  goal_operator = static_cast<std::uint32_t>(origin.size());
  add(goal, {goal_fact}, 0);
  operator_count = cost.size();
  precondition_of = Rows(transposed(precondition_rows, fact_count));
  effect_of = Rows(transposed(effect_rows, fact_count));
  preconditions = Rows(precondition_rows);
  effects = Rows(effect_rows);
}

}  // namespace goal_alignment::heuristics
