// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/ground_name.h"

#include <stdexcept>

#include "goal_alignment/common/quote.h"

namespace goal_alignment {

namespace {

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

[[noreturn]] void refuse(std::string_view text) {
  throw std::invalid_argument("expected '(name argument …)', found " + inQuotes(text));
}

/// Takes off one pair of parentheses, if there is one.
std::string_view insideParentheses(std::string_view text, std::string_view whole) {
  text = trimmed(text);
  if (text.empty()) refuse(whole);
  if (text.front() != '(') return text;
  if (text.back() != ')') refuse(whole);
  return trimmed(text.substr(1, text.size() - 2));
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isSpace(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back()))
    text.remove_suffix(1);
  return text;
}

std::string toLower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string GroundName::text() const {
  std::string result = "(" + name;
  for (const std::string& argument : arguments)
    result += " " + argument;
  return result + ")";
}

GroundName GroundName::parse(std::string_view text) {
  const std::string_view inside = insideParentheses(text, text);
  if (inside.find_first_of("()") != std::string_view::npos) refuse(text);
  GroundName result;
  for (std::size_t begin = 0; begin < inside.size();) {
    if (isSpace(inside[begin])) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < inside.size() && !isSpace(inside[end]))
      ++end;
    std::string word = toLower(inside.substr(begin, end - begin));
    if (result.name.empty()) {
      result.name = std::move(word);
    } else {
      result.arguments.push_back(std::move(word));
    }
    begin = end;
  }
  if (result.name.empty()) refuse(text);
  return result;
}

std::string Literal::text() const {
  return negated ? "(not " + atom.text() + ")" : atom.text();
}

Literal Literal::parse(std::string_view text) {
  const std::string_view inside = insideParentheses(text, text);
  const bool negated = inside.size() > 3 && toLower(inside.substr(0, 3)) == "not" &&
                       (isSpace(inside[3]) || inside[3] == '(');
  if (!negated) return {GroundName::parse(text), false};
  return {GroundName::parse(inside.substr(3)), true};
}

}  // namespace goal_alignment

std::size_t std::hash<goal_alignment::GroundName>::operator()(
    const goal_alignment::GroundName& ground) const noexcept {
  std::size_t seed = std::hash<std::string>{}(ground.name);
  for (const std::string& argument : ground.arguments) {
    seed ^=
        std::hash<std::string>{}(argument) + 0x9e3779b97f4a7c15ULL + (seed << 6U) + (seed >> 2U);
  }
  return seed;
}
