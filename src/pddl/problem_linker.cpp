// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "formula_linker.h"
#include "goal_alignment/pddl/atom_table.h"
#include "goal_alignment/pddl/near_name.h"
#include "link_context.h"

namespace goal_alignment::pddl {

namespace {

/// The same value twice is harmless; values that no action asks for may be missing.
void linkFunctionValue(LinkContext& context, const ast::FunctionValue& set) {
  const ast::Name& name = set.function.predicate;
  // Costs are counted from the start of the plan, whatever was spent before.
  if (toLower(name.spelling) == "total-cost" && set.function.terms.empty()) return;
  const std::string& source_name = context.problem.source->name;
  const Atom term = linkGroundAtom(context, set.function, functionsOf(context), source_name);
  const auto [known, is_new] = context.model.function_values.emplace(term, set.value);
  if (!is_new && known->second != set.value) {
    throw SemanticError(source_name, name.position,
                        "the function " + inQuotes(name.spelling) + " has two values here, " +
                            std::to_string(known->second) + " and " + std::to_string(set.value));
  }
}

/// Whether `(= a b)` between two objects holds.
bool holds(const LinkContext& context, const ast::Literal& equality) {
  const std::string& source_name = context.problem.source->name;
  const bool same = context.objects.at(equality.atom.terms[0], source_name) ==
                    context.objects.at(equality.atom.terms[1], source_name);
  return same != equality.negated;
}

void linkGoalLiteral(LinkContext& context, const ast::Literal& literal) {
  const std::string& source_name = context.problem.source->name;
  // An equality between objects is decided here and now; the goal keeps what a plan can change.
  if (!literal.equality) {
    context.model.goal.push_back(
        {linkGroundAtom(context, literal.atom, predicatesOf(context), source_name),
         literal.negated});
  } else if (!holds(context, literal)) {
    throw SemanticError(source_name, literal.atom.predicate.position,
                        "this equality of the goal can never hold");
  }
}

/// Literals that stand in it as conjuncts, say below two negations, join the others.
void addGoalCondition(Model& model, Formula part) {
  if (part.kind == Formula::Kind::And) {
    for (Formula& conjunct : part.parts)
      addGoalCondition(model, std::move(conjunct));
  } else if (part.kind == Formula::Kind::Literal) {
    Atom atom{part.literal.atom.predicate, {}};
    for (const Term& term : part.literal.atom.terms)
      atom.objects.push_back(term.index);
    model.goal.push_back({std::move(atom), part.literal.negated});
  } else {
    model.goal_condition.parts.push_back(std::move(part));
  }
}

}  // namespace

void linkInit(LinkContext& context) {
  const std::string& source_name = context.problem.source->name;
  AtomTable known;
  for (const ast::Atom& fact : context.problem.init) {
    context.pollLimits();
    const Atom atom = linkGroundAtom(context, fact, predicatesOf(context), source_name);
    if (known.insert(atom).second) context.model.init.push_back(atom);
  }
  // Under the closed world a negative fact says nothing new, but it must not contradict.
  for (const ast::Atom& fact : context.problem.init_false) {
    context.pollLimits();
    const Atom atom = linkGroundAtom(context, fact, predicatesOf(context), source_name);
    if (known.find(atom) != AtomTable::kNone) {
      throw SemanticError(
          source_name, fact.predicate.position,
          inQuotes(context.model.name(atom).text()) + " is both true and false in :init");
    }
  }
  for (const ast::FunctionValue& value : context.problem.init_values) {
    context.pollLimits();
    linkFunctionValue(context, value);
  }
}

void linkGoal(LinkContext& context) {
  const std::string& source_name = context.problem.source->name;
  FormulaLinker linker(context, source_name, " in the goal");
  linker.enter({});  // it has no parameters
  for (const ast::Formula& part : context.problem.goal) {
    if (part.kind == ast::Formula::Kind::Literal) {
      linkGoalLiteral(context, part.literal);
    } else {
      addGoalCondition(context.model, linker.formula(part));
    }
  }
  context.model.goal_variables = linker.variables();
}

}  // namespace goal_alignment::pddl
