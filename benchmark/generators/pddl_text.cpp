// SPDX-License-Identifier: BSD-3-Clause
#include "pddl_text.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace goal_alignment::benchmarks {
namespace {

std::string list(const std::vector<Typed>& names, const std::string& prefix = "") {
  std::string text;
  for (const Typed& name : names)
    text += " " + prefix + name.name + " - " + name.type;
  return text;
}

std::string conjunction(const std::vector<std::string>& literals) {
  std::string text = "(and";
  for (const std::string& literal : literals)
    text += " " + literal;
  return text + ")";
}

std::string actionText(const ActionParts& action) {
  std::vector<std::string> effects = action.add;
  for (const std::string& deleted : action.del)
    effects.push_back("(not " + deleted + ")");
  return "  (:action " + action.name + "\n    :parameters (" + list(action.parameters, "?") +
         ")\n    :precondition " + conjunction(action.condition) + "\n    :effect " +
         conjunction(effects) + ")\n";
}

}  // namespace

std::vector<Typed> typed(std::string_view text) {
  std::vector<Typed> result;
  std::size_t typed_up_to = 0;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    if (word != "-") {
      result.push_back({word.front() == '?' ? word.substr(1) : word, "object"});
      continue;
    }
    words >> word;
    for (; typed_up_to < result.size(); ++typed_up_to)
      result[typed_up_to].type = word;
  }
  return result;
}

std::string DomainParts::text() const {
  if (!whole.empty()) return whole;
  std::string text = "(define (domain " + name + ")\n  (:requirements :strips :typing)\n";
  if (!types.empty()) text += "  (:types" + list(types) + ")\n";
  text += "  (:predicates";
  for (const PredicateParts& predicate : predicates)
    text += "\n    (" + predicate.name + list(predicate.parameters, "?") + ")";
  text += ")\n";
  for (const ActionParts& action : actions)
    text += actionText(action);
  return text + ")\n";
}

bool DomainParts::isA(const std::string& type, const std::string& of) const {
  if (type == of || of == "object") return true;
  const auto entry = std::find_if(types.begin(), types.end(),
                                  [&](const Typed& known) { return known.name == type; });
  return entry != types.end() && entry->type != "object" && isA(entry->type, of);
}

const PredicateParts* DomainParts::predicate(const std::string& wanted) const {
  const auto found =
      std::find_if(predicates.begin(), predicates.end(),
                   [&](const PredicateParts& known) { return known.name == wanted; });
  return found == predicates.end() ? nullptr : &*found;
}

ActionParts& DomainParts::action(const std::string& wanted) {
  for (ActionParts& known : actions) {
    if (known.name == wanted) return known;
  }
  throw std::out_of_range("no action " + wanted);
}

std::vector<std::string> ProblemParts::addObjects(const std::string& stem, int count,
                                                  const std::string& type) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    names.push_back(numbered(stem, i));
    objects.push_back({names.back(), type});
  }
  return names;
}

std::string Models::problemText() const {
  std::string text = "(define (problem generated)\n  (:domain " + domain.name + ")\n  (:objects";
  for (const Typed& object : problem.objects)
    text += "\n    " + object.name + " - " + object.type;
  text += ")\n  (:init";
  for (const std::string& fact : problem.init)
    text += "\n    " + fact;
  return text + ")\n  (:goal " + conjunction(problem.goal) + "))\n";
}

std::string atom(std::initializer_list<std::string_view> words) {
  std::string text;
  for (const std::string_view word : words)
    text.append(text.empty() ? "(" : " ").append(word);
  return text + ")";
}

std::string numbered(const std::string& stem, int number) {
  return stem + std::to_string(number);
}

}  // namespace goal_alignment::benchmarks
