// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/arguments.h"

#include <fmt/format.h>

#include <utility>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::any_message {

Arguments::Arguments(const ActionDispatch& step, const YAML::Node& tables, std::string source)
    : tables_(tables), source_(std::move(source)) {
  objects_["action"] = step.name;
  for (std::size_t i = 0; i < step.parameters.size(); ++i) {
    objects_[std::to_string(i)] = step.parameters[i].value;
    objects_[toLower(step.parameters[i].key)] = step.parameters[i].value;
  }
}

std::string Arguments::object(const std::string& key, const YAML::Node& node) const {
  const auto found = objects_.find(toLower(key));
  if (found != objects_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& object : objects_)
    known.push_back(object.first);
  YamlReader(source_).failAt(
      node.Mark(), fmt::format("the action {} has no parameter {}{}", objects_.at("action"),
                               inQuotes(key), pddl::suggestion(key, known)));
}

YAML::Node Arguments::entry(const std::string& name, const YAML::Node& node) const {
  const std::size_t colon = name.find(':');
  const std::string table = name.substr(0, colon);
  const std::string of = toLower(object(name.substr(colon + 1), node));
  const YAML::Node& tables = tables_;  // a const one is not changed by looking
  const YAML::Node entries = tables.IsMap() ? tables[table] : YAML::Node();
  if (!entries.IsDefined() || !entries.IsMap()) {
    YamlReader(source_).failAt(node.Mark(), fmt::format("there is no table {}", inQuotes(table)));
  }
  std::vector<std::string> known;
  for (const auto& candidate : entries) {
    known.push_back(candidate.first.Scalar());
    if (toLower(known.back()) == of) return candidate.second;
  }
  YamlReader(source_).failAt(
      node.Mark(), fmt::format("table {} has no entry for {}{}", inQuotes(table), inQuotes(of),
                               pddl::suggestion(of, known)));
}

std::string Arguments::value(const std::string& name, const YAML::Node& node) const {
  if (name.find(':') == std::string::npos) return object(name, node);
  const YAML::Node found = entry(name, node);
  if (found.IsScalar()) return found.Scalar();
  YamlReader(source_).failAt(node.Mark(),
                             fmt::format("{{{}}} is {}: inside of a text expected a text", name,
                                         YamlReader::describe(found)));
}

std::string Arguments::fill(const YAML::Node& scalar) const {
  const std::string& text = scalar.Scalar();
  std::string filled;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool doubled = i + 1 < text.size() && text[i] == text[i + 1];
    if (text[i] == '}' && !doubled) {
      YamlReader(source_).failAt(scalar.Mark(), "'}' without '{' in " + inQuotes(text));
    }
    if (text[i] != '{' || doubled) {
      filled += text[i];
      if (doubled && (text[i] == '{' || text[i] == '}')) ++i;
      continue;
    }
    const std::size_t end = text.find('}', i);
    if (end == std::string::npos) {
      YamlReader(source_).failAt(scalar.Mark(), "'{' without '}' in " + inQuotes(text));
    }
    filled += value(text.substr(i + 1, end - i - 1), scalar);
    i = end;
  }
  return filled;
}

std::vector<std::string> Arguments::namesIn(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '{') continue;
    if (i + 1 < text.size() && text[i + 1] == '{') {
      ++i;
      continue;
    }
    const std::size_t end = text.find('}', i);
    if (end == std::string::npos) break;
    names.push_back(text.substr(i + 1, end - i - 1));
    i = end;
  }
  return names;
}

YAML::Node Arguments::resolve(const YAML::Node& node) const {
  if (!node.IsScalar()) return node;
  const std::string& text = node.Scalar();
  const bool whole = text.size() > 2 && text.front() == '{' && text[1] != '{' &&
                     text.find('}') == text.size() - 1 && text.find(':') != std::string::npos;
  return whole ? entry(text.substr(1, text.size() - 2), node) : node;
}

}  // namespace goal_alignment::any_message
