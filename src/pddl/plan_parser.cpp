// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>
#include <vector>

#include "formula_reader.h"
#include "goal_alignment/pddl/parser.h"

namespace goal_alignment::pddl {

namespace {

/// Names of plans and goals match without case; their spelling is the model's business.
GroundName groundName(const ast::Atom& atom) {
  GroundName ground{toLower(atom.predicate.spelling), {}};
  for (const ast::Name& term : atom.terms)
    ground.arguments.push_back(toLower(term.spelling));
  return ground;
}

/// `3:` or `0.00100:`, which temporal planners print before a step.
bool atTimestamp(const TokenReader& reader) {
  if (!reader.atWord()) return false;
  const std::string_view text = reader.current().text;
  return text.size() > 1 && text.find_first_not_of("0123456789.") == text.size() - 1 &&
         text.back() == ':';
}

/// `[1]` or `[1.000]`, which they print behind it.
bool atDuration(const TokenReader& reader) {
  if (!reader.atWord()) return false;
  const std::string_view text = reader.current().text;
  return text.size() > 2 && text.front() == '[' &&
         text.find_first_not_of("0123456789.", 1) == text.size() - 1 && text.back() == ']';
}

/// An action's name may be a word that formulas reserve: here it can't be mistaken.
GroundName readStep(TokenReader& reader) {
  ast::Atom action;
  action.predicate = reader.name("an action's name");
  action.terms = readTerms(reader, Terms::ObjectsOnly);
  return groundName(action);
}

}  // namespace

PlanText parsePlan(const Source& source) {
  PlanText plan;
  plan.source_name = source.name;
  TokenReader reader(source);
  while (!reader.atEnd()) {
    if (atTimestamp(reader)) reader.word("a time");
    plan.positions.push_back(reader.open("an action's '('"));
    plan.steps.push_back(readStep(reader));
    reader.close();
    if (atDuration(reader)) reader.word("a duration");
  }
  return plan;
}

std::vector<Literal> parseLiterals(const Source& source) {
  std::vector<Literal> literals;
  TokenReader reader(source);
  reader.setPlace("a list of literals");
  while (!reader.atEnd()) {
    reader.open("a literal's '('");
    const bool negated = reader.atWord("not");
    if (negated) {
      reader.word("'not'");
      reader.open("an atom's '('");
    }
    literals.push_back({groundName(readAtom(reader, Terms::ObjectsOnly, "a predicate")), negated});
    if (negated) reader.close();
    reader.close();
  }
  return literals;
}

}  // namespace goal_alignment::pddl
