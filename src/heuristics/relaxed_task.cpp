// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/relaxed_task.h"

#include <cstddef>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/task/relevance.h"

namespace goal_alignment::heuristics {

using task::FactId;
using task::OperatorId;

namespace {

using RowList = std::vector<std::vector<std::uint32_t>>;

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

RelaxedTask::RelaxedTask(const task::Task& task, const task::Goal& goal, const Limits& limits)
    : fact_count(task.facts.size() + 2),
      true_fact(static_cast<FactId>(task.facts.size())),
      goal_fact(true_fact + 1) {
  const std::vector<bool> relevant = task::relevance(task, goal, limits).operators;
  LimitMonitor monitor(limits);
  RowList precondition_rows;
  RowList effect_rows;
  const auto add = [&](task::FactSet precondition, const std::vector<FactId>& effect,
                       task::Cost operator_cost) {
    if (precondition.empty()) precondition.push_back(true_fact);
    precondition_rows.push_back(std::move(precondition));
    effect_rows.push_back(effect);
    cost.push_back(operator_cost);
  };
  RowList part_rows(task.operators.size());
  const auto add_part = [&](OperatorId op, task::FactSet precondition,
                            const task::FactSet& effect) {
    part_rows[op].push_back(static_cast<std::uint32_t>(origin.size()));
    origin.push_back(op);
    add(std::move(precondition), effect, task.operators[op].cost);
  };
  for (OperatorId op = 0; op < task.operators.size(); ++op) {
    pollOrThrow(monitor, "the relaxed task");
    if (!relevant[op]) continue;
    const task::Operator& whole = task.operators[op];
    if (!whole.add.empty()) add_part(op, whole.precondition, whole.add);
    for (const task::ConditionalEffect& effect : whole.conditional) {
      if (!effect.add.empty())
        add_part(op, task::unite(whole.precondition, effect.condition), effect.add);
    }
    if (part_rows[op].size() > 1) several_parts = true;
  }
  first_goal_operator = static_cast<std::uint32_t>(origin.size());
  for (const task::FactSet& alternative : goal.alternatives)
    add(alternative, {goal_fact}, 0);
  operator_count = cost.size();
  parts = Rows(part_rows);
  precondition_of = Rows(transposed(precondition_rows, fact_count));
  effect_of = Rows(transposed(effect_rows, fact_count));
  preconditions = Rows(precondition_rows);
  effects = Rows(effect_rows);
}

}  // namespace goal_alignment::heuristics
