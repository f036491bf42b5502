// SPDX-License-Identifier: BSD-3-Clause
#include "formula_reader.h"

#include <algorithm>
#include <array>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::pddl {

namespace {

struct Refused {
  std::string_view word;
  std::string_view construct;
};

/// PDDL's formulas that need more than conjunctions of literals.
constexpr std::array<Refused, 17> kRefused{{
    {"or", "'or' (a disjunction)"},
    {"imply", "'imply' (an implication)"},
    {"forall", "'forall' (a universal quantifier)"},
    {"exists", "'exists' (an existential quantifier)"},
    {"when", "'when' (a conditional effect)"},
    {"preference", "'preference' (a soft goal)"},
    {"either", "'either' (a union of types)"},
    {"<", "'<' (a numeric condition)"},
    {">", "'>' (a numeric condition)"},
    {"<=", "'<=' (a numeric condition)"},
    {">=", "'>=' (a numeric condition)"},
    {"decrease", "'decrease' (a numeric effect)"},
    {"assign", "'assign' (a numeric effect)"},
    {"scale-up", "'scale-up' (a numeric effect)"},
    {"scale-down", "'scale-down' (a numeric effect)"},
    {"oneof", "'oneof' (a nondeterministic effect)"},
    {"probabilistic", "'probabilistic' (a probabilistic effect)"},
}};

/// Linear, over few entries: a lookup table would not pay.
const Refused* findRefused(std::string_view lower_case) {
  const auto* found = std::find_if(kRefused.begin(), kRefused.end(),
                                   [&](const Refused& r) { return r.word == lower_case; });
  return found == kRefused.end() ? nullptr : found;
}

/// `= a b`. Parentheses behind the `=` mean function values, which need numeric fluents.
ast::Literal readEquality(TokenReader& reader, Terms terms) {
  const Token sign = reader.word("'='");
  if (reader.atOpen()) {
    reader.failUnsupported(sign.position, "'=' over functions (a numeric or object fluent)");
  }
  ast::Literal literal;
  literal.equality = true;
  literal.atom = {{"=", sign.position}, readTerms(reader, terms)};
  if (literal.atom.terms.size() != 2) {
    reader.fail(sign.position,
                "expected two terms after '=', found " + std::to_string(literal.atom.terms.size()));
  }
  return literal;
}

/// What follows `(` or `(not (`.
ast::Literal readPositive(TokenReader& reader, Terms terms, const std::string& what) {
  if (reader.atWord("=")) return readEquality(reader, terms);
  return {readAtom(reader, terms, what)};
}

/// `not (atom)`. Negation of anything but an atom would need disjunctions.
ast::Literal readNegated(TokenReader& reader, Terms terms) {
  reader.word("not", "'not'");
  reader.open("an atom's '('");
  if (reader.atWord("and") || reader.atWord("not")) {
    reader.failUnsupported(reader.current().position,
                           "'not' over '" + toLower(reader.current().text) + "'");
  }
  ast::Literal literal = readPositive(reader, terms, "a predicate");
  literal.negated = true;
  reader.close();
  return literal;
}

/// Recursion is as deep as the text nests, which the reader bounds.
void readConjuncts(TokenReader& reader, Terms terms, ast::Condition& into) {
  if (reader.atWord("and")) {
    reader.word("'and'");
    while (!reader.atClose()) {
      reader.open("'(' or ')'");
      readConjuncts(reader, terms, into);
    }
  } else if (reader.atWord("not")) {
    into.push_back(readNegated(reader, terms));
  } else if (!reader.atClose()) {
    into.push_back(readPositive(reader, terms, "a predicate, 'and', 'not' or ')'"));
  }
  reader.close();
}

}  // namespace

bool isReserved(std::string_view lower_case) {
  return lower_case == "and" || lower_case == "not" || lower_case == "increase" ||
         findRefused(lower_case) != nullptr;
}

void refuseReserved(const TokenReader& reader) {
  if (!reader.atWord()) return;
  const std::string lower_case = toLower(reader.current().text);
  if (const Refused* refused = findRefused(lower_case); refused != nullptr) {
    reader.failUnsupported(reader.current().position, std::string(refused->construct));
  }
  if (isReserved(lower_case)) reader.failExpecting("a predicate");
}

std::vector<ast::Name> readTerms(TokenReader& reader, Terms terms) {
  const bool lifted = terms == Terms::WithParameters;
  const char* what = lifted ? "a parameter, an object or ')'" : "an object or ')'";
  std::vector<ast::Name> read;
  while (!reader.atClose()) {
    const bool parameter = lifted && reader.atVariable();
    read.push_back(parameter ? reader.variable(what) : reader.name(what));
  }
  return read;
}

ast::Atom readAtom(TokenReader& reader, Terms terms, const std::string& what) {
  refuseReserved(reader);
  ast::Atom atom;
  atom.predicate = reader.name(what);
  atom.terms = readTerms(reader, terms);
  return atom;
}

ast::Condition readCondition(TokenReader& reader, Terms terms) {
  ast::Condition condition;
  reader.open();
  readConjuncts(reader, terms, condition);
  return condition;
}

}  // namespace goal_alignment::pddl
