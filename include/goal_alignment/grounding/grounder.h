// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/atom_table.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/task/task.h"

/// pddl ast → task. How names change between the layers:
///
///     text / ast            lifted model (ids)             grounded task
///     ------------------    ---------------------------    ------------------------------
///     Predicate, Atom       PredicateId, LiftedAtom        –
///     object, constant      ObjectId                       –
///     Action                Schema                         Operator, one per instantiation and
///                                                          alternative of its precondition
///     atom in :init         Atom in Model::init            FactId in Task::initial, or AlwaysTrue
///     (p ?x) in a           LiftedLiteral                  FactId, dropped when AlwaysTrue
///     precondition
///     (not (p ?x))          LiftedLiteral, negated         FactId of the complementary fact
///     (= ?x ?y)             Equality                       – (decided while joining)
///     or, exists, forall    Formula                        alternatives, each a conjunction
///     when, forall in an    ConditionalEffect              ConditionalEffect, one per
///     instantiation effect                                               and alternative
///     total-cost            constant_cost, function_costs  Operator::cost
namespace goal_alignment::grounding {

/// What a literal is for a grounded task.
struct FactStatus {
  enum class Kind : std::uint8_t {
    Variable,    ///< it is the fact `fact`
    AlwaysTrue,  ///< in every reachable state
    NeverTrue,   ///< in no reachable state, even without deletes (proven)
    Unknown,     ///< the model has no such predicate, object, arity or type: never true either
  };
  Kind kind = Kind::NeverTrue;
  task::FactId fact = 0;
};

struct Options {
  bool unit_costs = true;
};

/// A task and how its facts are called. Refers to the model it was grounded from.
class GroundTask {
 public:
  task::Task task;

  /// What the literal is here. Throws std::logic_error for a negated one that can change and that
  /// neither an operator nor `literals` of ground() named: no fact stands for it. O(length of its
  /// name).
  FactStatus status(const Literal& literal) const;

  /// The goal that these literals and the model's Model::goal_condition make together; without
  /// alternatives where that is proven impossible. For negated literals as status() says.
  task::Goal goal(const std::vector<Literal>& literals) const;

 private:
  friend class TaskBuilder;

  struct AtomStatus {
    FactStatus positive;
    std::optional<FactStatus> negative;  // nothing: it changes, and no fact says when it is so
  };

  const pddl::Model* model_ = nullptr;
  std::vector<task::FactSet> condition_;  // alternatives of the model's goal condition
  pddl::AtomTable atoms_;                 // the relaxed reachable ones
  std::vector<AtomStatus> statuses_;      // of these
};

/// Grounds by relaxed reachability. `literals` are goals that will be asked for: negated ones among
/// them get a complementary fact. Facts that never change are no part of the task. The model must
/// outlive the result.
///
/// Time and memory are proportional to the relaxed reachable part (see relaxed_reachability.h) and
/// the alternatives of its conditions. Throws LimitReached; pddl::SemanticError where an action's
/// cost is undefined; pddl::UnsupportedError where the conditions of an action with its arguments,
/// or the goal, have more than 10 000 alternatives.
GroundTask ground(const pddl::Model& model, const std::vector<Literal>& literals,
                  const Options& options, const Limits& limits);

}  // namespace goal_alignment::grounding
