// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/phrases.h"

/// Words and clauses one after the other.
namespace goal_alignment::phrasing {

namespace {

/// More clauses than a person listens to.
constexpr std::size_t kNamed = 5;

}  // namespace

/// "a", "a and b", "a, b and c".
std::string Phrases::enumeration(const std::vector<std::string>& words) const {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool last = i + 1 == words.size();
    result = i == 0 ? words[i] : say(last ? "list_last" : "list_more", {result, words[i]});
  }
  return result;
}

/// Clauses are longer than words and may hold an "and" themselves.
std::string Phrases::enumerationOfClauses(const std::vector<std::string>& clauses,
                                          std::size_t named) const {
  if (clauses.size() == 2) return say("clauses_two", clauses);
  std::string result;
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == clauses.size();
    result =
        i == 0 ? clauses[i] : say(last ? "clauses_last" : "clauses_more", {result, clauses[i]});
  }
  if (named == clauses.size()) return result;
  return say("clauses_cut", {result, std::to_string(clauses.size() - named)});
}

std::string Phrases::listed(const std::vector<Literal>& fluents, Spoken spoken, bool whole) const {
  std::vector<std::string> texts;
  texts.reserve(fluents.size());
  for (const Literal& fluent : fluents)
    texts.push_back((this->*spoken)(fluent));
  const bool cut = !whole && texts.size() > kNamed + 1;
  return enumerationOfClauses(texts, cut ? kNamed : texts.size());
}

std::string Phrases::clauses(const std::vector<Literal>& fluents) const {
  return listed(fluents, &Phrases::clause, true);
}

std::string Phrases::fewClauses(const std::vector<Literal>& fluents) const {
  return listed(fluents, &Phrases::clause, false);
}

std::string Phrases::thats(const std::vector<Literal>& fluents) const {
  return listed(fluents, &Phrases::that, true);
}

}  // namespace goal_alignment::phrasing
