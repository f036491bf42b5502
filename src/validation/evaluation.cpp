// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation.h"

#include <algorithm>

namespace goal_alignment::validation {

namespace {

pddl::ObjectId valueOf(const pddl::Term& term, const Binding& binding) {
  return term.is_parameter ? binding[term.index] : term.index;
}

}  // namespace

pddl::Atom instantiate(const pddl::LiftedAtom& lifted, const Binding& binding) {
  pddl::Atom atom{lifted.predicate, {}};
  atom.objects.reserve(lifted.terms.size());
  for (const pddl::Term& term : lifted.terms)
    atom.objects.push_back(valueOf(term, binding));
  return atom;
}

bool Evaluation::holds(const pddl::LiftedLiteral& literal) const {
  // Closed world: what the state does not hold is false.
  return (state_.count(instantiate(literal.atom, binding_)) > 0) != literal.negated;
}

bool Evaluation::holds(const pddl::Equality& equality) const {
  return (valueOf(equality.left, binding_) == valueOf(equality.right, binding_)) !=
         equality.negated;
}

bool Evaluation::holds(const pddl::Formula& formula) {
  using Kind = pddl::Formula::Kind;
  const auto part_holds = [this](const pddl::Formula& part) { return holds(part); };
  const auto first_part = [&](bool wanted) { return holds(formula.parts.front()) == wanted; };
  switch (formula.kind) {
    case Kind::Literal:
      return holds(formula.literal);
    case Kind::Equality:
      return holds(formula.equality);
    case Kind::And:
      return std::all_of(formula.parts.begin(), formula.parts.end(), part_holds);
    case Kind::Or:
      return std::any_of(formula.parts.begin(), formula.parts.end(), part_holds);
    case Kind::ForAll:
      return !anyBinding(formula.variables, [&] { return first_part(false); });
    case Kind::Exists:
      return anyBinding(formula.variables, [&] { return first_part(true); });
  }
  return false;
}

}  // namespace goal_alignment::validation
