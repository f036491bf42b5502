// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/validation/execution.h"

namespace goal_alignment::validation {

/// The objects that variables stand for, by index; kUnbound: none yet.
using Binding = std::vector<pddl::ObjectId>;
constexpr pddl::ObjectId kUnbound = -1;

/// The ground atom that the lifted one becomes.
pddl::Atom instantiate(const pddl::LiftedAtom& lifted, const Binding& binding);

/// What is true in one state, by the definitions: quantifiers range over the objects of their
/// types.
class Evaluation {
 public:
  /// `binding` has room for all of `variables`. Everything must outlive the evaluation. Polls the
  /// monitor at every object that a quantifier tries and throws LimitReached.
  Evaluation(const pddl::Model& model, const AtomSet& state,
             const std::vector<pddl::Parameter>& variables, Binding& binding, LimitMonitor& monitor)
      : model_(model), state_(state), variables_(variables), binding_(binding), monitor_(monitor) {}

  /// O(size · objects to the power of nested quantified variables).
  bool holds(const pddl::Formula& formula);
  bool holds(const pddl::LiftedLiteral& literal) const;
  bool holds(const pddl::Equality& equality) const;

  /// Of a formula that is false: ground literals that all are false, one of which would have to be
  /// true. Those that no action changes stand there only where there is no other. Empty: where
  /// there is nothing but equalities.
  std::vector<Literal> missing(const pddl::Formula& formula);

  /// Calls visit() under every binding of the variables to objects of their types, until it
  /// returns true; tells whether it did.
  template <typename Visit>
  bool anyBinding(const std::vector<int>& variables, Visit&& visit, std::size_t from = 0) {
    if (from == variables.size()) return visit();
    const auto variable = static_cast<std::size_t>(variables[from]);
    bool found = false;
    for (std::size_t o = 0; o < model_.objects.size() && !found; ++o) {
      pollLimits();
      if (!model_.isSubtype(model_.objects[o].type, variables_[variable].type)) continue;
      binding_[variable] = static_cast<pddl::ObjectId>(o);
      found = anyBinding(variables, visit, from + 1);
    }
    binding_[variable] = kUnbound;
    return found;
  }

 private:
  void collectFalse(const pddl::Formula& formula, bool with_static, std::vector<Literal>& into);
  bool isHopeless(const pddl::Formula& part);
  void pollLimits() { pollOrThrow(monitor_, "executing a plan"); }

  const pddl::Model& model_;
  const AtomSet& state_;
  const std::vector<pddl::Parameter>& variables_;
  Binding& binding_;
  LimitMonitor& monitor_;
};

}  // namespace goal_alignment::validation
