// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::grounding {

/// One way in which an action can be applied, or in which one of its conditional effects occurs: an
/// alternative of its condition's disjunctive normal form, as far as that is good to have lifted.
/// Variables are numbered as in pddl::Term::index.
struct Rule {
  static constexpr std::size_t kAction = static_cast<std::size_t>(-1);

  pddl::SchemaId schema = 0;
  std::size_t effect = kAction;          ///< index in Schema::conditional; kAction: the action
  std::vector<int> variables;            ///< to be bound: the parameters, then others that matter
  std::vector<pddl::LiftedAtom> body;    ///< atoms that must be true
  std::vector<pddl::LiftedAtom> absent;  ///< atoms that must be false
  std::vector<pddl::Equality> equalities;
  std::vector<const pddl::Formula*> residual;  ///< what is left to be grounded, in the model
  std::vector<pddl::LiftedAtom> head;          ///< what then appears
};

/// Stands for the fact that the action was reached with these arguments; rules of its conditional
/// effects begin with it.
pddl::PredicateId reachedPredicate(const pddl::Model& model, pddl::SchemaId schema);

/// Existential variables become variables of the rule; disjunctions are distributed while an action
/// or effect has at most 64 rules; universal conditions are left. Only rules whose variables have
/// objects. Throws LimitReached. O(64 · model).
std::vector<Rule> compileRules(const pddl::Model& model, const Limits& limits);

/// The parameter or quantified variable that a Term::index of this schema means.
const pddl::Parameter& variableOf(const pddl::Schema& schema, int index);

}  // namespace goal_alignment::grounding
