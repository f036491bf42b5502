// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/spatial_facts/rules.h"

namespace goal_alignment::spatial_facts {

/// What a rule takes from `defaults` where it does not say.
struct Settings {
  std::string frame = "map";
  double max_age = 2;   // seconds
  double margin = 0.1;  // metres
  Unknown unknown = Unknown::Fail;
};

/// A variable, by its index, or a name.
struct Term {
  std::string name;
  std::optional<std::size_t> variable;
};

/// `?who in ?room`, `cup within 1.2 of ?who`.
struct Condition {
  YAML::Mark mark;
  Term subject;
  Term other;
  bool in_region = false;
  double reach = 0;
  bool negated = false;
};

struct Variable {
  std::string name;
  std::vector<std::string> values;
};

/// A rule as it is written.
struct RuleText {
  YAML::Mark mark;  // of the fact
  GroundName fact;
  std::vector<Term> arguments;
  Condition condition;
  std::vector<Variable> variables;
  std::optional<std::size_t> exactly_one;  // a variable
  bool horizontal = false;
  Otherwise otherwise = Otherwise::Unknown;
  std::string otherwise_object;
  Settings settings;
};

/// max_age, margin and unknown of `fields` replace those of `settings`. Throws YamlError.
void readSettings(const YamlReader& reader, const YamlReader::Fields& fields, Settings& settings);

/// Throws YamlError.
RuleText readRule(const YamlReader& reader, const YAML::Node& node, const Settings& defaults);

/// A PDDL name in lower case. Throws YamlError.
std::string readName(const YamlReader& reader, const YAML::Node& node, const std::string& what);

}  // namespace goal_alignment::spatial_facts
