// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/near_name.h"
#include "link_context.h"

namespace goal_alignment::pddl {

namespace {

/// Pairs of files get mixed up, most of all where robot and human have one pair each.
void requireSameDomain(const ast::Domain& domain, const ast::Problem& problem) {
  if (toLower(domain.name.spelling) == toLower(problem.domain_name.spelling)) return;
  throw SemanticError(problem.source->name, problem.domain_name.position,
                      "the problem is for domain " + inQuotes(problem.domain_name.spelling) +
                          ", but " + domain.source->name + " defines " +
                          inQuotes(domain.name.spelling));
}

}  // namespace

LinkContext::LinkContext(const ast::Domain& domain_ast, const ast::Problem& problem_ast,
                         const Limits& limits)
    : domain(domain_ast), problem(problem_ast), monitor(limits) {
  model.domain_source = domain.source->name;
  model.problem_source = problem.source->name;
  model.has_costs = problem.minimises_total_cost;
}

void LinkContext::pollLimits() {
  pollOrThrow(monitor, "reading ", problem.source->name);
}

TypeId LinkContext::typeOf(const ast::TypedName& typed, const std::string& source_name) {
  if (!typed.type) return kObjectType;
  if (typed.type->either.empty()) return typeNamed(*typed.type, source_name);
  return unionOf(*this, *typed.type, source_name);
}

TypeId LinkContext::typeNamed(const ast::Name& name, const std::string& source_name) const {
  if (const std::optional<TypeId> id = types.find(name.spelling)) return *id;
  throw SemanticError(source_name, name.position,
                      types.unknown(name.spelling) +
                          (domain.types.empty() ? "; the domain declares no types" : ""));
}

Vocabulary predicatesOf(const LinkContext& context) {
  return {context.predicates, context.model.predicates};
}

Vocabulary functionsOf(const LinkContext& context) {
  return {context.functions, context.model.functions};
}

std::string wrongCount(const std::string& taker, std::size_t takes, std::size_t given) {
  return inQuotes(taker) + " takes " + std::to_string(takes) +
         (takes == 1 ? " argument" : " arguments") + ", found " + std::to_string(given);
}

std::string wrongType(const Model& model, std::string_view term, TypeId is,
                      const std::string& taker, TypeId wanted) {
  return inQuotes(term) + " is of type " + inQuotes(model.types[is].name.spelling) + ", but " +
         inQuotes(taker) + " takes " + inQuotes(model.types[wanted].name.spelling) + " there";
}

PredicateId signatureOf(const ast::Atom& atom, const Vocabulary& vocabulary,
                        const std::string& source_name) {
  const PredicateId id = vocabulary.names.at(atom.predicate, source_name);
  const Predicate& signature = vocabulary.signatures[id];
  if (atom.terms.size() != signature.parameter_types.size()) {
    throw SemanticError(
        source_name, atom.predicate.position,
        wrongCount(signature.name.spelling, signature.parameter_types.size(), atom.terms.size()));
  }
  return id;
}

Atom linkGroundAtom(const LinkContext& context, const ast::Atom& atom, const Vocabulary& vocabulary,
                    const std::string& source_name) {
  const Model& model = context.model;
  Atom ground{signatureOf(atom, vocabulary, source_name), {}};
  ground.objects.reserve(atom.terms.size());
  const Predicate& signature = vocabulary.signatures[ground.predicate];
  for (std::size_t i = 0; i < atom.terms.size(); ++i) {
    const ObjectId object = context.objects.at(atom.terms[i], source_name);
    const TypeId type = model.objects[object].type;
    const TypeId wanted = signature.parameter_types[i];
    // Strict, unlike for parameters: an object's type is all there is to know about it.
    if (!model.isSubtype(type, wanted)) {
      throw SemanticError(
          source_name, atom.terms[i].position,
          wrongType(model, atom.terms[i].spelling, type, signature.name.spelling, wanted));
    }
    ground.objects.push_back(object);
  }
  return ground;
}

void checkDomain(const ast::Domain& domain, const Limits& limits) {
  ast::Problem none;
  none.source = domain.source;
  LinkContext context(domain, none, limits);
  context.domain_alone = true;
  linkTypes(context);
  linkObjects(context);
  linkPredicatesAndFunctions(context);
  linkSchemas(context);
}

Model link(const ast::Domain& domain, const ast::Problem& problem, const Limits& limits) {
  requireSameDomain(domain, problem);
  // First alone: else a type that it uses and does not declare would be an object's in the problem.
  checkDomain(domain, limits);
  // Each step reads what the ones before it have declared.
  LinkContext context(domain, problem, limits);
  linkTypes(context);
  linkObjects(context);
  linkPredicatesAndFunctions(context);
  linkSchemas(context);
  linkInit(context);
  linkGoal(context);
  // The tables of types and functions served linking only.
  context.model.predicate_ids_ = std::move(context.predicates);
  context.model.object_ids_ = std::move(context.objects);
  context.model.schema_ids_ = std::move(context.schemas);
  return std::move(context.model);
}

}  // namespace goal_alignment::pddl
