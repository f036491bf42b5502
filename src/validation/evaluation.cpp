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

std::vector<Literal> Evaluation::missing(const pddl::Formula& formula) {
  std::vector<Literal> literals;
  for (const bool with_static : {false, true}) {
    if (literals.empty()) collectFalse(formula, with_static, literals);
  }
  std::sort(literals.begin(), literals.end());
  literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
  return literals;
}

// False, and nothing can be done about it.
bool Evaluation::isHopeless(const pddl::Formula& part) {
  using Kind = pddl::Formula::Kind;
  const bool fixed =
      part.kind == Kind::Equality ||
      (part.kind == Kind::Literal &&
       !model_.predicates[static_cast<std::size_t>(part.literal.atom.predicate)].fluent);
  return fixed && !holds(part);
}

void Evaluation::collectFalse(const pddl::Formula& formula, bool with_static,
                              std::vector<Literal>& into) {
  using Kind = pddl::Formula::Kind;
  const auto& parts = formula.parts;
  const auto collect = [&](const pddl::Formula& part) { collectFalse(part, with_static, into); };
  const auto is_hopeless = [this](const pddl::Formula& part) { return isHopeless(part); };
  if (holds(formula) || (!with_static && isHopeless(formula))) return;
  switch (formula.kind) {
    case Kind::Literal:
      into.push_back(
          {model_.name(instantiate(formula.literal.atom, binding_)), formula.literal.negated});
      break;
    case Kind::Equality:
      break;
    case Kind::And:
      if (!with_static && std::any_of(parts.begin(), parts.end(), is_hopeless)) break;
      collect(*std::find_if(parts.begin(), parts.end(),
                            [this](const pddl::Formula& part) { return !holds(part); }));
      break;
    case Kind::Or:
      std::for_each(parts.begin(), parts.end(), collect);
      break;
    case Kind::ForAll:
      anyBinding(formula.variables, [&] {
        if (holds(parts.front())) return false;
        collect(parts.front());
        return true;
      });
      break;
    case Kind::Exists:
      anyBinding(formula.variables, [&] {
        collect(parts.front());
        return false;
      });
      break;
  }
}

}  // namespace goal_alignment::validation
