// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include "goal_alignment/pddl/near_name.h"
#include "link_context.h"

namespace goal_alignment::pddl {

namespace {

/// One action schema, its names replaced by ids. The order matters: effects are checked against
/// what the precondition says about the parameters' types.
class SchemaLinker {
 public:
  SchemaLinker(LinkContext& context, const ast::Action& action)
      : context_(context), action_(action), source_name_(context.domain.source.name) {}

  Schema link() {
    schema_.name = {toLower(action_.name.spelling), action_.name.spelling};
    for (const ast::TypedName& parameter : action_.parameters)
      addParameter(parameter);
    for (const ast::Literal& literal : action_.precondition)
      addPrecondition(literal);
    for (const ast::Literal& literal : action_.effect)
      addEffect(literal);
    if (action_.cost) addCost(*action_.cost);
    return std::move(schema_);
  }

 private:
  void addParameter(const ast::TypedName& declared) {
    const std::string name = toLower(declared.name.spelling).substr(1);
    if (!parameters_.emplace(name, static_cast<int>(schema_.parameters.size())).second) {
      fail(declared.name,
           "parameter " + inQuotes(declared.name.spelling) + " stands twice" + here());
    }
    const TypeId type = context_.typeOf(declared, source_name_);
    schema_.parameters.push_back({name, type});
    narrowed_.push_back(type);
  }

  void addPrecondition(const ast::Literal& literal) {
    // `=` is built in and needs no predicate.
    if (literal.equality) {
      schema_.equalities.push_back(
          {term(literal.atom.terms[0]), term(literal.atom.terms[1]), literal.negated});
      return;
    }
    const LiftedAtom atom = lifted(literal.atom, predicatesOf(context_));
    schema_.precondition.push_back({atom, literal.negated});
    if (!literal.negated) narrow(atom);
  }

  void addEffect(const ast::Literal& literal) {
    const LiftedAtom atom = lifted(literal.atom, predicatesOf(context_));
    context_.model.predicates[atom.predicate].fluent = true;
    if (!literal.negated) refuseIllTypedAdd(literal.atom, atom);
    (literal.negated ? schema_.del : schema_.add).push_back(atom);
  }

  void addCost(const ast::CostEffect& cost) {
    schema_.constant_cost = cost.constant;
    if (cost.function) schema_.function_cost = lifted(*cost.function, functionsOf(context_));
  }

  LiftedAtom lifted(const ast::Atom& atom, const Vocabulary& vocabulary) const {
    LiftedAtom linked{signatureOf(atom, vocabulary, source_name_), {}};
    const Predicate& signature = vocabulary.signatures[linked.predicate];
    for (std::size_t i = 0; i < atom.terms.size(); ++i) {
      linked.terms.push_back(term(atom.terms[i]));
      checkType(atom.terms[i], linked.terms.back(), signature, signature.parameter_types[i]);
    }
    return linked;
  }

  // A parameter of the action, or an object by name: the domain's constants, and since problem
  // files are linked with it also its objects.
  Term term(const ast::Name& name) const {
    if (name.spelling.front() != '?') return {false, context_.objects.at(name, source_name_)};
    const auto found = parameters_.find(toLower(name.spelling).substr(1));
    if (found != parameters_.end()) return {true, found->second};
    std::vector<std::string> known;
    for (const ast::TypedName& parameter : action_.parameters) {
      known.push_back(parameter.name.spelling);
    }
    fail(name, "unknown parameter " + inQuotes(name.spelling) + here() +
                   suggestion(name.spelling, known));
  }

  /// A parameter of a wider type than the predicate's is usual: only its objects of the predicate's
  /// type can make the atom true. Types of which neither is the other's can't.
  void checkType(const ast::Name& name, const Term& term, const Predicate& signature,
                 TypeId wanted) const {
    const Model& model = context_.model;
    const TypeId is =
        term.is_parameter ? schema_.parameters[term.index].type : model.objects[term.index].type;
    if (model.isSubtype(is, wanted) || (term.is_parameter && model.isSubtype(wanted, is))) return;
    fail(name, wrongType(model, name.spelling, is, signature.name.spelling, wanted) + here());
  }

  /// Where the action is applicable, its parameters have the types of its positive preconditions.
  void narrow(const LiftedAtom& atom) {
    const Predicate& predicate = context_.model.predicates[atom.predicate];
    for (std::size_t i = 0; i < atom.terms.size(); ++i) {
      if (!atom.terms[i].is_parameter) continue;
      TypeId& type = narrowed_[atom.terms[i].index];
      if (context_.model.isSubtype(predicate.parameter_types[i], type)) {
        type = predicate.parameter_types[i];
      }
    }
  }

  /// Keeps every reachable state well typed, so that each of its atoms has a name that resolves.
  void refuseIllTypedAdd(const ast::Atom& written, const LiftedAtom& atom) const {
    const Model& model = context_.model;
    const Predicate& predicate = model.predicates[atom.predicate];
    for (std::size_t i = 0; i < atom.terms.size(); ++i) {
      if (!atom.terms[i].is_parameter) continue;
      const TypeId is = narrowed_[atom.terms[i].index];
      const TypeId wanted = predicate.parameter_types[i];
      if (model.isSubtype(is, wanted)) continue;
      fail(written.terms[i],
           wrongType(model, written.terms[i].spelling, is, predicate.name.spelling, wanted) +
               here() + ", and no precondition makes it one");
    }
  }

  std::string here() const { return " in action " + inQuotes(action_.name.spelling); }

  [[noreturn]] void fail(const ast::Name& at, const std::string& message) const {
    throw SemanticError(source_name_, at.position, message);
  }

  LinkContext& context_;
  const ast::Action& action_;
  const std::string& source_name_;
  Schema schema_;
  std::unordered_map<std::string, int> parameters_;
  std::vector<TypeId> narrowed_;  ///< each parameter's type where the action is applicable
};

}  // namespace

void linkSchemas(LinkContext& context) {
  for (const ast::Action& action : context.domain.actions) {
    const auto id = static_cast<SchemaId>(context.model.schemas.size());
    if (!context.schemas.add(action.name.spelling, id)) {
      throw SemanticError(context.domain.source.name, action.name.position,
                          "action " + inQuotes(action.name.spelling) + " is declared twice");
    }
    context.model.schemas.push_back(SchemaLinker(context, action).link());
  }
}

}  // namespace goal_alignment::pddl
