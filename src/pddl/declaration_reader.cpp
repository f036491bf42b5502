// SPDX-License-Identifier: BSD-3-Clause
#include "declaration_reader.h"

#include <algorithm>
#include <memory>

#include "foreign_keyword.h"
#include "formula_reader.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::pddl {

namespace {

/// Bounds what Model::isSubtype() costs.
constexpr std::size_t kLargestUnion = 100;

/// A type, or `(either a b)`.
ast::TypeName readType(TokenReader& reader) {
  if (!reader.atOpen()) return {reader.name("a type"), {}};
  reader.open();
  const Token either = reader.word("either", "'either'");
  ast::TypeName type{{either.text, either.position}, {}};
  do
    type.either.push_back(reader.name("a type"));
  while (!reader.atClose());
  if (type.either.size() > kLargestUnion) {
    reader.failUnsupported(either.position,
                           "'either' of more than " + std::to_string(kLargestUnion) + " types");
  }
  reader.close();
  return type;
}

/// `(name ?x - type …)`: of a predicate or a function.
ast::Predicate readSignature(TokenReader& reader, const std::string& what) {
  reader.open("'(' or ')'");
  if (reader.atWord() && isReserved(toLower(reader.current().text))) {
    reader.failExpecting(what, ", which PDDL reserves");
  }
  ast::Predicate predicate;
  predicate.name = reader.name(what);
  predicate.parameters = readTypedList(reader, ListOf::Variables, "a variable such as '?x'");
  reader.close();
  return predicate;
}

/// The `- number` that may follow a function.
void readFunctionType(TokenReader& reader) {
  if (!reader.atDash()) return;
  reader.dash();
  // Other types than `number` make it an object fluent.
  const ast::TypeName type = readType(reader);
  if (toLower(type.spelling) != "number") {
    reader.failUnsupported(type.position,
                           "a function to " + inQuotes(type.spelling) + " (an object fluent)");
  }
}

}  // namespace

ast::Name readHeader(TokenReader& reader, const std::string& kind) {
  reader.open("'(define'");
  reader.word("define", "'define'");
  reader.open("'(" + kind + "'");
  reader.word(kind, "'" + kind + "'");
  ast::Name name = reader.name("the " + kind + "'s name");
  reader.close();
  return name;
}

std::vector<ast::Name> readRequirements(TokenReader& reader) {
  std::vector<ast::Name> requirements;
  while (!reader.atClose()) {
    const std::string what = "a requirement such as ':strips' or ')'";
    if (reader.atWord() && reader.current().text.front() != ':') reader.failExpecting(what);
    const Token flag = reader.word(what);
    requirements.push_back({flag.text, flag.position});
  }
  return requirements;
}

std::vector<ast::TypedName> readTypedList(TokenReader& reader, ListOf kind,
                                          const std::string& what) {
  std::vector<ast::TypedName> list;
  std::size_t typed = 0;  // names before this one have got their type
  while (!reader.atClose()) {
    const std::string expected = what + (typed < list.size() ? ", '-' or ')'" : " or ')'");
    if (typed == list.size() || !reader.atDash()) {
      const bool variables = kind == ListOf::Variables;
      list.push_back({variables ? reader.variable(expected) : reader.name(expected), {}});
      continue;
    }
    reader.dash();
    const auto type = std::make_shared<const ast::TypeName>(readType(reader));
    if (kind == ListOf::Types && !type->either.empty()) {
      reader.failUnsupported(type->position, "'either' (a union of types) as a parent");
    }
    while (typed < list.size())
      list[typed++].type = type;
  }
  return list;
}

std::vector<ast::Predicate> readPredicates(TokenReader& reader) {
  std::vector<ast::Predicate> predicates;
  while (!reader.atClose())
    predicates.push_back(readSignature(reader, "a predicate's name"));
  return predicates;
}

std::vector<ast::Predicate> readFunctions(TokenReader& reader) {
  std::vector<ast::Predicate> functions;
  while (!reader.atClose()) {
    functions.push_back(readSignature(reader, "a function's name"));
    readFunctionType(reader);
  }
  return functions;
}

void expectSection(const TokenReader& reader, const Sections& sections) {
  const auto here = [&](const std::string& keyword) { return reader.atWord(keyword); };
  if (std::any_of(sections.known.begin(), sections.known.end(), here)) return;
  refuseForeign(reader);
  const std::string found(reader.atWord() ? reader.current().text : "");
  reader.failExpecting(sections.expected, suggestion(found, sections.known));
}

void SectionLog::note(const TokenReader& reader) {
  const Token& keyword = reader.current();
  const auto [first, is_new] = seen_.emplace(toLower(keyword.text), keyword.position);
  if (!is_new) {
    reader.fail(keyword.position, inQuotes(keyword.text) +
                                      " stands here a second time; the first is at " +
                                      toString(first->second));
  }
}

}  // namespace goal_alignment::pddl
