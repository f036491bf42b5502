// SPDX-License-Identifier: BSD-3-Clause
#include "ground_condition.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::grounding {

using pddl::Formula;
using task::FactId;
using task::FactSet;

namespace {

Alternatives always() {
  return {FactSet{}};
}

bool isFalse(const Alternatives& condition) {
  return condition.empty();
}

bool isTrue(const Alternatives& condition) {
  return condition.size() == 1 && condition.front().empty();
}

}  // namespace

void ConditionGrounder::enter(const std::vector<pddl::Parameter>& variables,
                              std::vector<pddl::ObjectId> binding) {
  variables_ = &variables;
  binding_ = std::move(binding);
}

void ConditionGrounder::pollLimits() {
  pollOrThrow(monitor_, "grounding");
}

Alternatives ConditionGrounder::of(const pddl::LiftedAtom& atom, bool negated) {
  const Decided decided = facts_.decide(groundAtom(atom, binding_), negated);
  if (decided.kind == Decided::Kind::Fact) return {FactSet{decided.fact}};
  return decided.kind == Decided::Kind::True ? always() : Alternatives{};
}

Alternatives ConditionGrounder::of(const Formula& formula) {
  pollLimits();
  const auto value = [this](const pddl::Term& term) {
    return term.is_parameter ? binding_[static_cast<std::size_t>(term.index)] : term.index;
  };
  const bool conjunctive = formula.kind == Formula::Kind::And;
  std::vector<Alternatives> parts;
  switch (formula.kind) {
    case Formula::Kind::Literal:
      return of(formula.literal.atom, formula.literal.negated);
    case Formula::Kind::Equality: {
      const bool same = value(formula.equality.left) == value(formula.equality.right);
      return same != formula.equality.negated ? always() : Alternatives{};
    }
    case Formula::Kind::ForAll:
    case Formula::Kind::Exists:
      return ofQuantified(formula);
    case Formula::Kind::And:
    case Formula::Kind::Or:
      break;
  }
  for (const Formula& part : formula.parts) {
    parts.push_back(of(part));
    if (conjunctive ? isFalse(parts.back()) : isTrue(parts.back())) return parts.back();
  }
  return ofParts(std::move(parts), conjunctive);
}

Alternatives ConditionGrounder::ofQuantified(const Formula& formula) {
  std::vector<Alternatives> parts;
  collect(formula, 0, parts);
  return ofParts(std::move(parts), formula.kind == Formula::Kind::ForAll);
}

/// The quantifier's part under every binding of its variables, without those that change nothing;
/// the one alone that decides.
void ConditionGrounder::collect(const Formula& formula, std::size_t from,
                                std::vector<Alternatives>& parts) {
  const bool universal = formula.kind == Formula::Kind::ForAll;
  const auto decides = [&](const Alternatives& part) {
    return universal ? isFalse(part) : isTrue(part);
  };
  if (from == formula.variables.size()) {
    Alternatives part = of(formula.parts.front());
    if (universal ? isTrue(part) : isFalse(part)) return;
    if (decides(part)) parts.clear();
    parts.push_back(std::move(part));
    return;
  }
  const auto variable = static_cast<std::size_t>(formula.variables[from]);
  for (std::size_t o = 0; o < model_.objects.size(); ++o) {
    pollLimits();
    if (!model_.isSubtype(model_.objects[o].type, (*variables_)[variable].type)) continue;
    binding_[variable] = static_cast<pddl::ObjectId>(o);
    collect(formula, from + 1, parts);
    if (!parts.empty() && decides(parts.front())) return;
  }
}

/// The smallest first: what they fix makes contradictions of the others' alternatives early.
Alternatives ConditionGrounder::ofParts(std::vector<Alternatives> parts, bool conjunctive) {
  if (conjunctive) {
    Alternatives product = always();
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.size() < b.size(); });
    // Most are single facts; joined one by one they would take quadratic time.
    FactSet facts;
    for (const Alternatives& part : parts) {
      if (part.size() == 1) facts.insert(facts.end(), part.front().begin(), part.front().end());
    }
    product.front() = task::makeFactSet(std::move(facts));
    if (contradicts(product.front())) return {};
    for (const Alternatives& part : parts) {
      if (part.size() != 1) product = conjunction(product, part);
    }
    return product;
  }
  Alternatives sum;
  for (Alternatives& part : parts) {
    std::move(part.begin(), part.end(), std::back_inserter(sum));
    if (sum.size() > 2 * TooManyAlternatives::kMost) sum = minimal(std::move(sum));
  }
  return minimal(std::move(sum));
}

bool ConditionGrounder::contradicts(const FactSet& conjunction) const {
  return std::any_of(conjunction.begin(), conjunction.end(), [&](FactId fact) {
    const FactId opposite = facts_.opposite(fact);
    return opposite != kNoFact && task::has(conjunction, opposite);
  });
}

Alternatives ConditionGrounder::conjunction(const Alternatives& a, const Alternatives& b) {
  Alternatives product;
  for (const FactSet& left : a) {
    for (const FactSet& right : b) {
      pollLimits();
      FactSet both = task::unite(left, right);
      if (!contradicts(both)) product.push_back(std::move(both));
    }
    if (product.size() > 2 * TooManyAlternatives::kMost) {
      product = minimal(std::move(product));
    }
  }
  return minimal(std::move(product));
}

Alternatives ConditionGrounder::minimal(Alternatives condition) {
  std::sort(condition.begin(), condition.end(), [](const FactSet& x, const FactSet& y) {
    return x.size() != y.size() ? x.size() < y.size() : x < y;
  });
  condition.erase(std::unique(condition.begin(), condition.end()), condition.end());
  Alternatives minimal;
  std::ptrdiff_t smaller = 0;  // how many of these have fewer facts than the next: others can't be
  for (FactSet& alternative : condition) {
    pollLimits();
    if (!minimal.empty() && minimal.back().size() < alternative.size()) {
      smaller = static_cast<std::ptrdiff_t>(minimal.size());
    }
    const bool implied =
        std::any_of(minimal.begin(), minimal.begin() + smaller, [&](const FactSet& other) {
          return std::includes(alternative.begin(), alternative.end(), other.begin(), other.end());
        });
    if (!implied) minimal.push_back(std::move(alternative));
    if (minimal.size() > TooManyAlternatives::kMost) throw TooManyAlternatives{};
  }
  return minimal;
}

Alternatives ConditionGrounder::negation(const FactSet& conjunction) {
  Alternatives result;
  for (const FactId fact : conjunction)
    result.push_back({facts_.addOpposite(fact)});
  return minimal(std::move(result));
}

}  // namespace goal_alignment::grounding
