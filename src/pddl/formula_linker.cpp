// SPDX-License-Identifier: BSD-3-Clause
#include "formula_linker.h"

#include <algorithm>

#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::pddl {

namespace {

/// One that only the problem may declare.
constexpr ObjectId kAnyObject = -1;

}  // namespace

std::vector<int> FormulaLinker::enter(const std::vector<ast::TypedName>& variables) {
  std::vector<int> entered;
  std::vector<Hidden> hidden;
  const auto first = static_cast<int>(variables_.size());
  for (const ast::TypedName& declared : variables) {
    context_.pollLimits();
    const std::string name = toLower(declared.name.spelling).substr(1);
    const auto index = static_cast<int>(variables_.size());
    const auto [known, is_new] = indices_.emplace(name, index);
    if (!is_new && known->second >= first) {
      const char* kind = scopes_.empty() ? "parameter " : "variable ";
      fail(declared.name, kind + inQuotes(declared.name.spelling) + " stands twice" + here_);
    }
    hidden.push_back({name, is_new ? std::nullopt : std::optional<int>(known->second)});
    known->second = index;
    variables_.push_back({name, context_.typeOf(declared, source_name_)});
    entered.push_back(index);
  }
  scopes_.push_back(std::move(hidden));
  return entered;
}

void FormulaLinker::leave() {
  for (const Hidden& hidden : scopes_.back()) {
    if (hidden.index) {
      indices_[hidden.name] = *hidden.index;
    } else {
      indices_.erase(hidden.name);
    }
  }
  scopes_.pop_back();
}

LiftedAtom FormulaLinker::atom(const ast::Atom& atom, const Vocabulary& vocabulary) const {
  LiftedAtom linked{signatureOf(atom, vocabulary, source_name_), {}};
  const Predicate& signature = vocabulary.signatures[linked.predicate];
  for (std::size_t i = 0; i < atom.terms.size(); ++i) {
    linked.terms.push_back(term(atom.terms[i]));
    checkType(atom.terms[i], linked.terms.back(), signature, signature.parameter_types[i]);
  }
  return linked;
}

Equality FormulaLinker::equality(const ast::Literal& literal) const {
  return {term(literal.atom.terms[0]), term(literal.atom.terms[1]), literal.negated};
}

// A variable, or an object by name: the domain's constants, and since problem files are linked with
// it also its objects.
Term FormulaLinker::term(const ast::Name& name) const {
  if (name.spelling.front() != '?') {
    if (context_.domain_alone && !context_.objects.find(name.spelling)) return {false, kAnyObject};
    return {false, context_.objects.at(name, source_name_)};
  }
  const auto found = indices_.find(toLower(name.spelling).substr(1));
  if (found != indices_.end()) return {true, found->second};
  std::vector<std::string> known;
  for (const auto& [variable, index] : indices_)
    known.push_back("?" + variable);
  std::sort(known.begin(), known.end());
  fail(name,
       "unknown parameter " + inQuotes(name.spelling) + here_ + suggestion(name.spelling, known));
}

/// A variable of a wider type than the predicate's is usual: only its objects of the predicate's
/// type can make the atom true. Types without an object in common can't.
void FormulaLinker::checkType(const ast::Name& name, const Term& term, const Predicate& signature,
                              TypeId wanted) const {
  if (!term.is_parameter && term.index == kAnyObject) return;
  const Model& model = context_.model;
  const TypeId is =
      term.is_parameter ? variables_[term.index].type : model.objects[term.index].type;
  if (term.is_parameter ? model.overlap(is, wanted) : model.isSubtype(is, wanted)) return;
  fail(name, wrongType(model, name.spelling, is, signature.name.spelling, wanted) + here_);
}

Formula FormulaLinker::literal(const ast::Literal& written, bool negated) const {
  Formula formula;
  if (written.equality) {
    formula.kind = Formula::Kind::Equality;
    formula.equality = equality(written);
    formula.equality.negated = written.negated != negated;
  } else {
    formula.kind = Formula::Kind::Literal;
    formula.literal = {atom(written.atom, predicatesOf(context_)), written.negated != negated};
  }
  return formula;
}

Formula FormulaLinker::quantified(const ast::Formula& written, bool negated) {
  const bool universal = (written.kind == ast::Formula::Kind::ForAll) != negated;
  Formula formula;
  formula.kind = universal ? Formula::Kind::ForAll : Formula::Kind::Exists;
  formula.variables = enter(written.variables);
  formula.parts.push_back(this->formula(written.parts.front(), negated));
  leave();
  return formula;
}

Formula FormulaLinker::formula(const ast::Formula& written, bool negated) {
  using Kind = ast::Formula::Kind;
  context_.pollLimits();
  switch (written.kind) {
    case Kind::Literal:
      return literal(written.literal, negated);
    case Kind::Not:
      return formula(written.parts.front(), !negated);
    case Kind::ForAll:
    case Kind::Exists:
      return quantified(written, negated);
    case Kind::And:
    case Kind::Or:
    case Kind::Imply:
      break;
  }
  // De Morgan: a negation turns `and` into `or` on its way inwards.
  Formula result;
  const bool conjunctive = (written.kind == Kind::And) != negated;
  result.kind = conjunctive ? Formula::Kind::And : Formula::Kind::Or;
  for (std::size_t i = 0; i < written.parts.size(); ++i) {
    const bool premise = written.kind == Kind::Imply && i == 0;
    result.parts.push_back(formula(written.parts[i], negated != premise));
  }
  return result;
}

Formula FormulaLinker::conjunction(const ast::Condition& written) {
  Formula result;
  for (const ast::Formula& part : written)
    result.parts.push_back(formula(part));
  return result;
}

void FormulaLinker::fail(const ast::Name& at, const std::string& message) const {
  throw SemanticError(source_name_, at.position, message);
}

}  // namespace goal_alignment::pddl
