// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/phrases.h"

#include <optional>

namespace goal_alignment::phrasing {

namespace {

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// `good-leaves` → "good leaves", `level_2` → "level 2". A separator after a digit stays, since in
/// names such as `f0-1` it tells two numbers apart.
std::string spoken(const std::string& name) {
  std::string result = name;
  for (std::size_t i = 1; i + 1 < result.size(); ++i) {
    if ((result[i] == '-' || result[i] == '_') && isLetter(result[i - 1])) result[i] = ' ';
  }
  return result;
}

/// "a", "a and b", "a, b and c".
std::string enumeration(const std::vector<std::string>& words) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) result += i + 1 == words.size() ? " and " : ", ";
    result += words[i];
  }
  return result;
}

/// Clauses are longer than words and may hold an "and" themselves: "a, and b", "a; b; and c".
std::string enumerationOfClauses(const std::vector<std::string>& clauses) {
  const std::string separator = clauses.size() > 2 ? "; " : ", ";
  std::string result;
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    if (i > 0) result += separator + (i + 1 == clauses.size() ? "and " : "");
    result += clauses[i];
  }
  return result;
}

/// What is said of a predicate that nobody wrote a sentence for.
std::string bareClause(const GroundName& atom, const std::vector<std::string>& arguments,
                       bool negated) {
  const std::string verb = negated ? " does not hold" : " holds";
  const std::string rest = arguments.empty() ? "" : " for " + enumeration(arguments);
  return "\"" + spoken(atom.name) + "\"" + verb + rest;
}

std::optional<std::string> fill(const std::map<std::string, TemplateText>& templates,
                                const std::string& name,
                                const std::vector<std::string>& arguments) {
  const auto found = templates.find(name);
  return found == templates.end() ? std::nullopt : found->second.fill(arguments);
}

}  // namespace

std::string Phrases::object(const std::string& name) const {
  const auto found = objects_.find(name);
  return found == objects_.end() ? spoken(name) : found->second;
}

std::vector<std::string> Phrases::spokenArguments(const GroundName& ground) const {
  std::vector<std::string> result;
  result.reserve(ground.arguments.size());
  for (const std::string& argument : ground.arguments)
    result.push_back(object(argument));
  return result;
}

std::string Phrases::clause(const Literal& fluent) const {
  const std::vector<std::string> arguments = spokenArguments(fluent.atom);
  const auto affirmative = fill(affirmative_, fluent.atom.name, arguments);
  if (!fluent.negated) return affirmative.value_or(bareClause(fluent.atom, arguments, false));
  if (const auto negated = fill(negated_, fluent.atom.name, arguments)) return *negated;
  return affirmative ? "it is not so that " + *affirmative
                     : bareClause(fluent.atom, arguments, true);
}

std::string Phrases::question(const std::vector<Literal>& fluents) const {
  if (fluents.empty()) return "";
  if (fluents.size() == 1) return "Does it matter to you that " + clause(fluents.front()) + "?";
  std::vector<std::string> clauses;
  clauses.reserve(fluents.size());
  for (const Literal& fluent : fluents)
    clauses.push_back("that " + clause(fluent));
  return "Which of these matter to you: " + enumerationOfClauses(clauses) + "?";
}

std::string Phrases::reason(const std::vector<Literal>& conflict, bool proven) const {
  if (conflict.empty()) return "";
  const std::string can_have = proven ? "I can't have " : "I could not make sure that I can have ";
  if (conflict.size() == 1) {
    const std::string can_make =
        proven ? "I can't make it so that " : "I could not make sure that I can make it so that ";
    return can_make + clause(conflict.front()) + ", given what you asked for.";
  }
  std::vector<std::string> clauses;
  clauses.reserve(conflict.size());
  for (const Literal& fluent : conflict)
    clauses.push_back(clause(fluent));
  const std::string count = conflict.size() == 2 ? "both: " : "all of these together: ";
  return can_have + count + enumerationOfClauses(clauses) + ".";
}

std::string Phrases::action(const GroundName& step) const {
  const std::vector<std::string> arguments = spokenArguments(step);
  if (const auto text = fill(actions_, step.name, arguments)) return *text;
  std::string result = spoken(step.name);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    result += (i == 0 ? ": " : ", ") + arguments[i];
  }
  return result;
}

}  // namespace goal_alignment::phrasing
