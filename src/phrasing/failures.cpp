// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "goal_alignment/phrasing/phrases.h"

/// What went wrong: why a step can't be done, and what others say of it.
namespace goal_alignment::phrasing {

using Kind = validation::Violation::Kind;

std::string Phrases::reasonOf(const validation::Violation& violation) const {
  switch (violation.kind) {
    case Kind::UnknownAction:
      return say("fails_unknown");
    case Kind::WrongArity:
      return say("fails_number");
    case Kind::UnknownObject:
      return say("fails_object", {object(violation.object)});
    case Kind::WrongType:
      return say("fails_kind", {object(violation.object)});
    case Kind::Precondition:
      break;
  }
  if (violation.missing.empty()) return say("fails_unsaid");
  if (violation.missing.size() > 1) return say("fails_as_none", {fewClauses(violation.missing)});
  const Literal& missing = violation.missing.front();
  return say("fails_as", {clause({missing.atom, !missing.negated})});
}

std::string Phrases::failure(const validation::Violation& violation, const GroundName& step) const {
  const std::string number = std::to_string(violation.step + 1);
  return say("step_fails", {number, action(step), reasonOf(violation)});
}

std::optional<std::string> Phrases::wordsFor(const std::string& pddl) const {
  try {
    const Literal literal = Literal::parse(pddl);
    if (predicates_.count(literal.atom.name) > 0) return clause(literal);
    if (!literal.negated && actions_.count(literal.atom.name) > 0) return action(literal.atom);
  } catch (const std::invalid_argument&) {  // other brackets
  }
  return std::nullopt;
}

std::string Phrases::inWords(const std::string& text) const {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    int depth = 0;
    do {
      depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
      ++end;
    } while (depth > 0 && end < text.size());
    const std::string part = text.substr(at, end - at);
    const auto words = text[at] == '(' && depth == 0 ? wordsFor(part) : std::nullopt;
    result += words ? "(" + *words + ")" : part.substr(0, 1);
    at = words ? end : at + 1;
  }
  return result;
}

}  // namespace goal_alignment::phrasing
