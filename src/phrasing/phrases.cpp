// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/phrases.h"

#include <array>
#include <cstddef>
#include <utility>

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

}  // namespace

std::string Phrases::say(const std::string& name, const std::vector<std::string>& arguments) const {
  return frames_->fill(name, arguments);
}

std::string Phrases::counted(const std::string& name, std::size_t number,
                             const std::vector<std::string>& more) const {
  return frames_->counted(name, number, more);
}

Filling Phrases::filling(const std::string& name) const {
  const auto found = objects_.find(name);
  return found == objects_.end() ? Filling{spoken(name), {}} : found->second;
}

std::string Phrases::object(const std::string& name) const {
  return filling(name).text;
}

std::vector<Filling> Phrases::fillings(const GroundName& ground) const {
  std::vector<Filling> result;
  result.reserve(ground.arguments.size());
  for (const std::string& argument : ground.arguments)
    result.push_back(filling(argument));
  return result;
}

std::vector<std::string> Phrases::spokenArguments(const GroundName& ground) const {
  std::vector<std::string> result;
  result.reserve(ground.arguments.size());
  for (const std::string& argument : ground.arguments)
    result.push_back(object(argument));
  return result;
}

std::optional<std::string> Phrases::form(const GroundName& atom, Form form) const {
  const auto found = predicates_.find(atom.name);
  if (found == predicates_.end()) return std::nullopt;
  const auto& sentence = found->second.*form;
  return sentence ? sentence->fillIn(fillings(atom)) : std::nullopt;
}

/// What is said of a predicate that nobody wrote a sentence for.
std::string Phrases::bareClause(const Literal& fluent, Place place) const {
  using Names = std::array<const char*, 2>;  // affirmative and negated
  const bool alone = place == Place::Alone;
  const Names equality = alone ? Names{"same", "different"} : Names{"that_same", "that_different"};
  const Names bare = alone ? Names{"holds", "holds_not"} : Names{"that_holds", "that_holds_not"};
  const Names of_things =
      alone ? Names{"holds_for", "holds_not_for"} : Names{"that_holds_for", "that_holds_not_for"};
  const std::size_t form = fluent.negated ? 1 : 0;
  const std::vector<std::string> arguments = spokenArguments(fluent.atom);
  if (fluent.atom.name == "=" && arguments.size() == 2) return say(equality.at(form), arguments);
  const std::string name = spoken(fluent.atom.name);
  if (arguments.empty()) return say(bare.at(form), {name});
  return say(of_things.at(form), {name, enumeration(arguments)});
}

std::string Phrases::clause(const Literal& fluent) const {
  const auto affirmative = form(fluent.atom, &Forms::affirmative);
  if (!fluent.negated) return affirmative ? *affirmative : bareClause(fluent, Place::Alone);
  if (const auto negated = form(fluent.atom, &Forms::negated)) return *negated;
  if (!affirmative) return bareClause(fluent, Place::Alone);
  return form(fluent.atom, &Forms::that) ? say("not_so", {that({fluent.atom, false})})
                                         : say("not_so_plain", {*affirmative});
}

std::string Phrases::that(const Literal& fluent) const {
  if (const auto own = form(fluent.atom, fluent.negated ? &Forms::that_not : &Forms::that))
    return say("that", {*own});
  const auto affirmative = form(fluent.atom, &Forms::affirmative);
  if (fluent.negated && form(fluent.atom, &Forms::negated))
    return say("that_plain", {clause(fluent)});
  if (!affirmative) return bareClause(fluent, Place::AfterThat);
  if (!fluent.negated) return say("that_plain", {*affirmative});
  return form(fluent.atom, &Forms::that) ? say("that_not_so", {that({fluent.atom, false})})
                                         : say("that_not_so_plain", {*affirmative});
}

std::string Phrases::action(const GroundName& step) const {
  const auto found = actions_.find(step.name);
  const auto text = found == actions_.end() ? std::nullopt : found->second.fillIn(fillings(step));
  if (text) return *text;
  std::string things;
  for (const std::string& argument : spokenArguments(step))
    things = things.empty() ? argument : say("list_more", {things, argument});
  return things.empty() ? spoken(step.name) : say("action_with", {spoken(step.name), things});
}

}  // namespace goal_alignment::phrasing
