// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/grounding/rules.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::grounding {

using pddl::Formula;
using pddl::LiftedAtom;
using pddl::Model;
using pddl::Schema;
using pddl::SchemaId;
using pddl::Term;

namespace {

constexpr std::size_t kMaxRules = 64;

/// A conjunction in the making.
struct Alternative {
  std::vector<int> variables;  // existential ones
  std::vector<LiftedAtom> body;
  std::vector<LiftedAtom> absent;
  std::vector<pddl::Equality> equalities;
  std::vector<const Formula*> residual;
};
using Alternatives = std::vector<Alternative>;

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Alternative both(Alternative a, const Alternative& b) {
  append(a.variables, b.variables);
  append(a.body, b.body);
  append(a.absent, b.absent);
  append(a.equalities, b.equalities);
  append(a.residual, b.residual);
  return a;
}

Alternatives lift(const Formula& formula);

Alternatives leave(const Formula& formula) {
  Alternative alternative;
  alternative.residual.push_back(&formula);
  return {std::move(alternative)};
}

/// The product; a conjunct that would make it too large stays as it is.
Alternatives liftConjunction(const Formula& formula) {
  Alternatives product(1);
  for (const Formula& part : formula.parts) {
    Alternatives factor = lift(part);
    if (product.size() * factor.size() > kMaxRules) factor = leave(part);
    Alternatives next;
    for (const Alternative& a : product) {
      for (const Alternative& b : factor)
        next.push_back(both(a, b));
    }
    product = std::move(next);
  }
  return product;
}

Alternatives liftDisjunction(const Formula& formula) {
  Alternatives sum;
  for (const Formula& part : formula.parts) {
    append(sum, lift(part));
    if (sum.size() > kMaxRules) return leave(formula);
  }
  return sum;
}

/// Recursion is as deep as the text nests.
Alternatives lift(const Formula& formula) {
  Alternative alternative;
  switch (formula.kind) {
    case Formula::Kind::And:
      return liftConjunction(formula);
    case Formula::Kind::Or:
      return liftDisjunction(formula);
    case Formula::Kind::ForAll:
      return leave(formula);
    case Formula::Kind::Exists: {
      Alternatives alternatives = lift(formula.parts.front());
      for (Alternative& each : alternatives)
        append(each.variables, formula.variables);
      return alternatives;
    }
    case Formula::Kind::Literal:
      (formula.literal.negated ? alternative.absent : alternative.body)
          .push_back(formula.literal.atom);
      break;
    case Formula::Kind::Equality:
      alternative.equalities.push_back(formula.equality);
      break;
  }
  return {std::move(alternative)};
}

/// Which variables occur in something.
class Occurrences {
 public:
  explicit Occurrences(std::size_t variables) : occurs_(variables, false) {}

  bool operator[](int variable) const { return occurs_[static_cast<std::size_t>(variable)]; }

  void note(const Term& term) {
    if (term.is_parameter) occurs_[static_cast<std::size_t>(term.index)] = true;
  }
  void note(const LiftedAtom& atom) {
    for (const Term& term : atom.terms)
      note(term);
  }
  void note(const std::vector<LiftedAtom>& atoms) {
    for (const LiftedAtom& atom : atoms)
      note(atom);
  }
  void note(const pddl::Equality& equality) {
    note(equality.left);
    note(equality.right);
  }
  void note(const Formula& formula) {
    if (formula.kind == Formula::Kind::Literal) note(formula.literal.atom);
    if (formula.kind == Formula::Kind::Equality) note(formula.equality);
    for (const Formula& part : formula.parts)
      note(part);
  }
  void note(const Alternative& alternative) {
    note(alternative.body);
    note(alternative.absent);
    for (const pddl::Equality& equality : alternative.equalities)
      note(equality);
    for (const Formula* formula : alternative.residual)
      note(*formula);
  }

 private:
  std::vector<bool> occurs_;
};

class Compiler {
 public:
  Compiler(const Model& model, const Limits& limits) : model_(model), monitor_(limits) {}

  std::vector<Rule> compile() {
    for (std::size_t s = 0; s < model_.schemas.size(); ++s)
      addSchema(static_cast<SchemaId>(s));
    return std::move(rules_);
  }

 private:
  void addSchema(SchemaId id) {
    const Schema& schema = model_.schemas[static_cast<std::size_t>(id)];
    Alternative literals;
    for (const pddl::LiftedLiteral& literal : schema.precondition)
      (literal.negated ? literals.absent : literals.body).push_back(literal.atom);
    literals.equalities = schema.equalities;
    LiftedAtom reached{reachedPredicate(model_, id), {}};
    for (std::size_t i = 0; i < schema.parameters.size(); ++i)
      reached.terms.push_back({true, static_cast<int>(i)});
    for (const Alternative& alternative : lift(schema.condition)) {
      std::vector<LiftedAtom> head = schema.add;
      if (!schema.conditional.empty()) head.push_back(reached);
      addRule(id, Rule::kAction, both(literals, alternative), {}, std::move(head));
    }
    for (std::size_t e = 0; e < schema.conditional.size(); ++e) {
      const pddl::ConditionalEffect& effect = schema.conditional[e];
      Alternative action;
      action.body.push_back(reached);
      for (const Alternative& alternative : lift(effect.condition))
        addRule(id, e, both(action, alternative), effect.variables, effect.add);
    }
  }

  /// Variables that occur nowhere need an object to exist, no more.
  void addRule(SchemaId id, std::size_t effect, Alternative alternative, std::vector<int> universal,
               std::vector<LiftedAtom> head) {
    const Schema& schema = model_.schemas[static_cast<std::size_t>(id)];
    pollLimits();
    Rule rule;
    rule.schema = id;
    rule.effect = effect;
    Occurrences occurs(schema.parameters.size() + schema.quantified.size());
    occurs.note(alternative);
    occurs.note(head);
    if (effect != Rule::kAction) occurs.note(schema.conditional[effect].del);
    for (std::size_t i = 0; i < schema.parameters.size(); ++i)
      rule.variables.push_back(static_cast<int>(i));
    append(universal, alternative.variables);
    for (const int variable : universal) {
      if (!inhabited(variableOf(schema, variable).type)) return;
      if (occurs[variable]) rule.variables.push_back(variable);
    }
    rule.body = std::move(alternative.body);
    rule.absent = std::move(alternative.absent);
    rule.equalities = std::move(alternative.equalities);
    rule.residual = std::move(alternative.residual);
    rule.head = std::move(head);
    rules_.push_back(std::move(rule));
  }

  void pollLimits() { pollOrThrow(monitor_, "grounding"); }

  bool inhabited(pddl::TypeId type) {
    pollLimits();
    const auto [known, is_new] = inhabited_.emplace(type, false);
    if (is_new) {
      known->second = std::any_of(
          model_.objects.begin(), model_.objects.end(),
          [&](const pddl::Object& object) { return model_.isSubtype(object.type, type); });
    }
    return known->second;
  }

  const Model& model_;
  LimitMonitor monitor_;
  std::unordered_map<pddl::TypeId, bool> inhabited_;
  std::vector<Rule> rules_;
};

}  // namespace

pddl::PredicateId reachedPredicate(const Model& model, SchemaId schema) {
  return static_cast<pddl::PredicateId>(model.predicates.size()) + schema;
}

const pddl::Parameter& variableOf(const Schema& schema, int index) {
  const auto at = static_cast<std::size_t>(index);
  const std::size_t parameters = schema.parameters.size();
  return at < parameters ? schema.parameters[at] : schema.quantified[at - parameters];
}

std::vector<Rule> compileRules(const Model& model, const Limits& limits) {
  return Compiler(model, limits).compile();
}

}  // namespace goal_alignment::grounding
