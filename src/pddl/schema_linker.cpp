// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "formula_linker.h"
#include "goal_alignment/pddl/near_name.h"
#include "link_context.h"

namespace goal_alignment::pddl {

namespace {

/// The types that each variable is known to have where a condition holds, besides its own; none of
/// them says what another one does.
using NarrowedTypes = std::vector<std::vector<TypeId>>;

/// One action schema, its names replaced by ids. The order matters: effects are checked against
/// what the conditions say about the variables' types.
class SchemaLinker {
 public:
  SchemaLinker(LinkContext& context, const ast::Action& action)
      : context_(context),
        action_(action),
        linker_(context, context.domain.source->name,
                " in action " + inQuotes(action.name.spelling)) {}

  Schema link() {
    schema_.name = Spelled(action_.name.spelling);
    linker_.enter(action_.parameters);
    schema_.parameters = linker_.variables();
    Formula precondition = linker_.conjunction(action_.precondition);
    NarrowedTypes narrowed;
    narrow(precondition, narrowed);
    addPrecondition(std::move(precondition));
    for (const ast::Literal& literal : action_.effect)
      addEffect(literal, narrowed, schema_.add, schema_.del);
    for (const ast::ConditionalEffect& effect : action_.conditional)
      addConditional(effect, {}, narrowed);
    for (const ast::CostEffect& cost : action_.costs)
      addCost(cost);
    const auto behind = static_cast<std::ptrdiff_t>(schema_.parameters.size());
    schema_.quantified.assign(linker_.variables().begin() + behind, linker_.variables().end());
    return std::move(schema_);
  }

 private:
  /// Literals and equalities, be they nested in conjunctions, apart from what needs more.
  void addPrecondition(Formula part) {
    if (part.kind == Formula::Kind::Literal) {
      schema_.precondition.push_back(std::move(part.literal));
    } else if (part.kind == Formula::Kind::Equality) {
      schema_.equalities.push_back(part.equality);
    } else if (part.kind == Formula::Kind::And) {
      for (Formula& conjunct : part.parts)
        addPrecondition(std::move(conjunct));
    } else {
      schema_.condition.parts.push_back(std::move(part));
    }
  }

  void addEffect(const ast::Literal& literal, const NarrowedTypes& narrowed,
                 std::vector<LiftedAtom>& add, std::vector<LiftedAtom>& del) {
    const LiftedAtom atom = linker_.atom(literal.atom, predicatesOf(context_));
    context_.model.predicates[atom.predicate].fluent = true;
    if (!literal.negated) refuseIllTypedAdd(literal.atom, atom, narrowed);
    (literal.negated ? del : add).push_back(atom);
  }

  /// One effect for each `forall` or `when` that has literals of its own. `outer`: the variables
  /// and conditions around it; the reader bounds how often they are copied.
  void addConditional(const ast::ConditionalEffect& written, ConditionalEffect outer,
                      NarrowedTypes narrowed) {
    const std::vector<int> variables = linker_.enter(written.variables);
    outer.variables.insert(outer.variables.end(), variables.begin(), variables.end());
    Formula condition = linker_.conjunction(written.condition);
    narrow(condition, narrowed);
    for (Formula& part : condition.parts)
      outer.condition.parts.push_back(std::move(part));
    if (!written.literals.empty()) {
      ConditionalEffect effect = outer;
      for (const ast::Literal& literal : written.literals)
        addEffect(literal, narrowed, effect.add, effect.del);
      schema_.conditional.push_back(std::move(effect));
    }
    for (const ast::ConditionalEffect& nested : written.nested)
      addConditional(nested, outer, narrowed);
    linker_.leave();
  }

  void addCost(const ast::CostEffect& cost) {
    schema_.constant_cost += cost.constant;
    if (!cost.function) return;
    schema_.function_costs.push_back(linker_.atom(*cost.function, functionsOf(context_)));
  }

  /// The last one says the most of where it came from.
  std::vector<TypeId> typesOf(int variable, const NarrowedTypes& narrowed) const {
    const auto index = static_cast<std::size_t>(variable);
    const bool known = index < narrowed.size() && !narrowed[index].empty();
    return known ? narrowed[index] : std::vector<TypeId>{linker_.variables()[index].type};
  }

  bool anyIs(const std::vector<TypeId>& types, TypeId wanted) const {
    return std::any_of(types.begin(), types.end(),
                       [&](TypeId type) { return context_.model.isSubtype(type, wanted); });
  }

  /// Adds one to the types that a variable has.
  void narrow(std::vector<TypeId>& types, TypeId type) const {
    if (anyIs(types, type)) return;
    const auto said = [&](TypeId known) { return context_.model.isSubtype(type, known); };
    types.erase(std::remove_if(types.begin(), types.end(), said), types.end());
    types.push_back(type);
  }

  /// Where a formula holds, its variables have the types of the atoms that must be true.
  void narrow(const Formula& formula, NarrowedTypes& narrowed) const {
    if (formula.kind == Formula::Kind::And || formula.kind == Formula::Kind::Exists) {
      for (const Formula& part : formula.parts)
        narrow(part, narrowed);
    }
    if (formula.kind != Formula::Kind::Literal || formula.literal.negated) return;
    const LiftedAtom& atom = formula.literal.atom;
    const Predicate& predicate = context_.model.predicates[atom.predicate];
    narrowed.resize(linker_.variables().size());
    for (std::size_t i = 0; i < atom.terms.size(); ++i) {
      if (!atom.terms[i].is_parameter) continue;
      const int variable = atom.terms[i].index;
      std::vector<TypeId> types = typesOf(variable, narrowed);
      narrow(types, predicate.parameter_types[i]);
      narrowed[variable] = std::move(types);
    }
  }

  /// Keeps every reachable state well typed, so that each of its atoms has a name that resolves.
  void refuseIllTypedAdd(const ast::Atom& written, const LiftedAtom& atom,
                         const NarrowedTypes& narrowed) const {
    const Model& model = context_.model;
    const Predicate& predicate = model.predicates[atom.predicate];
    for (std::size_t i = 0; i < atom.terms.size(); ++i) {
      if (!atom.terms[i].is_parameter) continue;
      const std::vector<TypeId> are = typesOf(atom.terms[i].index, narrowed);
      const TypeId wanted = predicate.parameter_types[i];
      if (anyIs(are, wanted)) continue;
      linker_.fail(written.terms[i], wrongType(model, written.terms[i].spelling, are.back(),
                                               predicate.name.spelling, wanted) +
                                         linker_.here() + ", and no precondition makes it one");
    }
  }

  LinkContext& context_;
  const ast::Action& action_;
  FormulaLinker linker_;
  Schema schema_;
};

}  // namespace

void linkSchemas(LinkContext& context) {
  for (const ast::Action& action : context.domain.actions) {
    const auto id = static_cast<SchemaId>(context.model.schemas.size());
    if (!context.schemas.add(action.name.spelling, id)) {
      throw SemanticError(context.domain.source->name, action.name.position,
                          "action " + inQuotes(action.name.spelling) + " is declared twice");
    }
    context.model.schemas.push_back(SchemaLinker(context, action).link());
  }
}

}  // namespace goal_alignment::pddl
