// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "goal_alignment/common/ground_name.h"

/// The grounded task: propositional STRIPS with positive preconditions (negative ones are compiled
/// into complementary facts by the grounding floor) and non-negative whole costs.
namespace goal_alignment::task {

using FactId = std::uint32_t;
using OperatorId = std::uint32_t;
using Cost = std::int64_t;

/// A conjunction of facts, sorted, without duplicates.
using FactSet = std::vector<FactId>;

/// What an operator does besides, where the condition is true in the state it is applied in.
struct ConditionalEffect {
  FactSet condition;
  FactSet add;
  FactSet del;
};

/// One ground action. Where it both adds and deletes a fact, be it by different effects, the add
/// wins. Several operators may have one name: an action whose precondition is a disjunction.
struct Operator {
  GroundName name;
  FactSet precondition;
  FactSet add;
  FactSet del;
  Cost cost = 1;
  std::vector<ConditionalEffect> conditional = {};
};

/// A goal in disjunctive normal form: satisfied where all facts of one alternative are true.
/// Without alternatives it never is; a conjunction has one.
struct Goal {
  std::vector<FactSet> alternatives;

  Goal() = default;
  Goal(FactSet conjunction) : alternatives{std::move(conjunction)} {}  // NOLINT: one is a goal
  explicit Goal(std::vector<FactSet> disjunction) : alternatives(std::move(disjunction)) {}
};

/// The goal and these facts besides, in any order.
Goal withFacts(Goal goal, std::vector<FactId> facts);

/// Facts, operators and an initial state. Goals are no part of it: one task serves many goal sets.
/// A large one is freed by another thread.
struct Task {
  std::vector<Literal> facts;  ///< by FactId; negated: a complementary fact
  std::vector<Operator> operators;
  FactSet initial;

  Task() = default;
  Task(const Task&) = default;
  Task(Task&&) = default;
  Task& operator=(const Task&) = default;
  Task& operator=(Task&&) = default;
  ~Task();
};

/// Operators in the order of their execution.
using Plan = std::vector<OperatorId>;

/// Sum of the operators' costs.
Cost cost(const Task& task, const Plan& plan);

/// The operators' names, in order.
std::vector<GroundName> names(const Task& task, const Plan& plan);

/// Sorts and removes duplicates.
FactSet makeFactSet(std::vector<FactId> facts);

/// The facts of either. O(one + other).
FactSet unite(const FactSet& one, const FactSet& other);

/// O(log set).
bool has(const FactSet& set, FactId fact);

}  // namespace goal_alignment::task
