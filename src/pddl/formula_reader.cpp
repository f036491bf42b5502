// SPDX-License-Identifier: BSD-3-Clause
#include "formula_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "declaration_reader.h"
#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::pddl {

namespace {

struct Refused {
  std::string_view word;
  std::string_view construct;
};

/// The words of formulas and effects that we treat.
constexpr std::array<std::string_view, 9> kTreated{"and",    "or",   "not",    "imply",   "forall",
                                                   "exists", "when", "either", "increase"};

/// PDDL's formulas and effects that need more than the truth of atoms.
constexpr std::array<Refused, 11> kRefused{{
    {"preference", "'preference' (a soft goal)"},
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

ast::Formula composed(ast::Formula::Kind kind, std::vector<ast::Formula> parts) {
  ast::Formula formula;
  formula.kind = kind;
  formula.parts = std::move(parts);
  return formula;
}

void readConjuncts(TokenReader& reader, Terms terms, ast::Condition& into);

/// One formula with its parentheses.
ast::Formula readFormula(TokenReader& reader, Terms terms, const std::string& what = "'('") {
  reader.open(what);
  ast::Condition conjuncts;
  readConjuncts(reader, terms, conjuncts);
  if (conjuncts.size() == 1) return std::move(conjuncts.front());
  return composed(ast::Formula::Kind::And, std::move(conjuncts));
}

/// `not formula`; over an atom it makes a literal.
ast::Formula readNegated(TokenReader& reader, Terms terms) {
  reader.word("not", "'not'");
  ast::Formula negated = readFormula(reader, terms, "a formula's '('");
  if (negated.kind == ast::Formula::Kind::Literal && !negated.literal.negated) {
    negated.literal.negated = true;
    return negated;
  }
  std::vector<ast::Formula> part;
  part.push_back(std::move(negated));
  return composed(ast::Formula::Kind::Not, std::move(part));
}

ast::Formula readDisjunction(TokenReader& reader, Terms terms) {
  reader.word("or", "'or'");
  std::vector<ast::Formula> parts;
  while (!reader.atClose())
    parts.push_back(readFormula(reader, terms, "'(' or ')'"));
  return composed(ast::Formula::Kind::Or, std::move(parts));
}

ast::Formula readImplication(TokenReader& reader, Terms terms) {
  reader.word("imply", "'imply'");
  std::vector<ast::Formula> parts;
  parts.push_back(readFormula(reader, terms));
  parts.push_back(readFormula(reader, terms));
  return composed(ast::Formula::Kind::Imply, std::move(parts));
}

/// `forall (variable …) formula` or `exists …`. Below it variables may stand for objects.
ast::Formula readQuantified(TokenReader& reader) {
  using Kind = ast::Formula::Kind;
  const bool universal = reader.atWord("forall");
  reader.word("'forall' or 'exists'");
  std::vector<ast::TypedName> variables = readVariables(reader);
  std::vector<ast::Formula> part;
  part.push_back(readFormula(reader, Terms::WithParameters));
  ast::Formula formula = composed(universal ? Kind::ForAll : Kind::Exists, std::move(part));
  formula.variables = std::move(variables);
  return formula;
}

ast::Formula literalFormula(ast::Literal literal) {
  ast::Formula formula;
  formula.literal = std::move(literal);
  return formula;
}

/// Enters behind the `(`, leaves behind its `)`. Recursion is as deep as the text nests, which the
/// reader bounds.
void readConjuncts(TokenReader& reader, Terms terms, ast::Condition& into) {
  if (reader.atWord("and")) {
    reader.word("'and'");
    while (!reader.atClose()) {
      reader.open("'(' or ')'");
      readConjuncts(reader, terms, into);
    }
  } else if (reader.atWord("not")) {
    into.push_back(readNegated(reader, terms));
  } else if (reader.atWord("or")) {
    into.push_back(readDisjunction(reader, terms));
  } else if (reader.atWord("imply")) {
    into.push_back(readImplication(reader, terms));
  } else if (reader.atWord("forall") || reader.atWord("exists")) {
    into.push_back(readQuantified(reader));
  } else if (reader.atWord("=")) {
    into.push_back(literalFormula(readEquality(reader, terms)));
  } else if (!reader.atClose()) {
    into.push_back(literalFormula({readAtom(reader, terms, "a predicate, 'and', 'not' or ')'")}));
  }
  reader.close();
}

}  // namespace

bool isReserved(std::string_view lower_case) {
  return std::find(kTreated.begin(), kTreated.end(), lower_case) != kTreated.end() ||
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

std::vector<ast::TypedName> readVariables(TokenReader& reader) {
  reader.open();
  std::vector<ast::TypedName> variables =
      readTypedList(reader, ListOf::Variables, "a variable such as '?x'");
  reader.close();
  return variables;
}

ast::Names readTerms(TokenReader& reader, Terms terms) {
  const bool lifted = terms == Terms::WithParameters;
  const char* what = lifted ? "a parameter, an object or ')'" : "an object or ')'";
  ast::Names read;
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
