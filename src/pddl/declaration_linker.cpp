// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>

#include "goal_alignment/pddl/near_name.h"
#include "link_context.h"

namespace goal_alignment::pddl {

namespace {

constexpr const char* kTotalCost = "total-cost";

/// Overloading by arity or type is no part of PDDL: the same name twice is a slip.
[[noreturn]] void failDeclaredTwice(const std::string& kind, const ast::Name& name,
                                    const std::string& source_name) {
  throw SemanticError(source_name, name.position,
                      kind + " " + inQuotes(name.spelling) + " is declared twice");
}

/// The types of a predicate's or function's parameters; their names mean nothing.
Predicate signature(LinkContext& context, const ast::Predicate& declared) {
  Predicate linked{Spelled(declared.name.spelling), {}};
  for (const ast::TypedName& parameter : declared.parameters) {
    linked.parameter_types.push_back(context.typeOf(parameter, context.domain.source->name));
  }
  return linked;
}

void linkSignatures(LinkContext& context, const std::vector<ast::Predicate>& declared,
                    NameTable& names, std::vector<Predicate>& into) {
  for (const ast::Predicate& predicate : declared) {
    if (!names.add(predicate.name.spelling, static_cast<PredicateId>(into.size()))) {
      failDeclaredTwice(names.kind(), predicate.name, context.domain.source->name);
    }
    into.push_back(signature(context, predicate));
  }
}

/// IPC problems repeat constants among their objects; with the same type that is harmless.
bool repeatsConstant(const LinkContext& context, const ast::TypedName& declared, TypeId type,
                     std::size_t constants) {
  const std::optional<ObjectId> known = context.objects.find(declared.name.spelling);
  return known && static_cast<std::size_t>(*known) < constants &&
         context.model.objects[*known].type == type;
}

/// `constants`: how many objects the domain has declared before.
void addObjects(LinkContext& context, const std::vector<ast::TypedName>& list,
                const std::string& source_name, std::size_t constants) {
  // A constant may be repeated once: twice in one list is a slip like any other.
  std::vector<bool> repeated(constants, false);
  for (const ast::TypedName& declared : list) {
    context.pollLimits();
    const TypeId type = context.typeOf(declared, source_name);
    const std::string_view spelling = declared.name.spelling;
    if (context.objects.add(spelling, static_cast<ObjectId>(context.model.objects.size()))) {
      context.model.objects.push_back({Spelled(spelling), type});
      continue;
    }
    if (!repeatsConstant(context, declared, type, constants) ||
        repeated[*context.objects.find(spelling)]) {
      failDeclaredTwice("object", declared.name, source_name);
    }
    repeated[*context.objects.find(spelling)] = true;
  }
}

}  // namespace

void linkObjects(LinkContext& context) {
  addObjects(context, context.domain.constants, context.domain.source->name, 0);
  addObjects(context, context.problem.objects, context.problem.source->name,
             context.model.objects.size());
}

void linkPredicatesAndFunctions(LinkContext& context) {
  linkSignatures(context, context.domain.predicates, context.predicates, context.model.predicates);
  // total-cost is no function that an action's cost may name: it has no value in the initial state
  // that would matter.
  std::vector<ast::Predicate> functions;
  for (const ast::Predicate& function : context.domain.functions) {
    if (toLower(function.name.spelling) != kTotalCost) functions.push_back(function);
  }
  linkSignatures(context, functions, context.functions, context.model.functions);
}

}  // namespace goal_alignment::pddl
