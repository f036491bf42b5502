// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "goal_alignment/task/state.h"
#include "goal_alignment/task/task.h"

/// Naive implementations kept as oracles: by the definitions, with nothing clever in them.
namespace goal_alignment::oracles {

/// A state of a grounded task, spelled out.
using Facts = std::set<task::FactId>;

Facts initialFacts(const task::Task& task);
Facts factsOf(const task::Task& task, const task::Word* state);
task::State stateOf(const task::Task& task, const Facts& facts);

bool holds(const task::FactSet& goal, const Facts& facts);
bool holds(const task::Goal& goal, const Facts& facts);
Facts successor(const task::Operator& op, const Facts& facts);

/// Tests every operator. In rising order.
std::vector<task::OperatorId> applicableOperators(const task::Task& task, const Facts& facts);

/// Every state reachable from `from`, with the cost of a cheapest way to it (Dijkstra).
std::map<Facts, task::Cost> reachable(const task::Task& task, const Facts& from);

/// The cost of a cheapest plan; nothing: there is none.
std::optional<task::Cost> optimalCost(const task::Task& task, const Facts& from,
                                      const task::Goal& goal);

/// Where the operators lead from the initial state; nothing where one can't be applied.
std::optional<Facts> execute(const task::Task& task, const task::Plan& plan);

}  // namespace goal_alignment::oracles
