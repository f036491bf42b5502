// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/common/yaml_reader.h"

namespace goal_alignment::any_message {

/// What the texts of a mapping stand for in one step of a plan: `{to}` is the object that the
/// action's parameter ?to has, `{0}` that of the first one, `{action}` the action's name,
/// `{pose:to}` the entry of table `pose` for the object of ?to, and `{{` a brace.
class Arguments {
 public:
  /// `tables`: maps of maps, the inner keys in lower case. `source` names the file in errors.
  Arguments(const ActionDispatch& step, const YAML::Node& tables, std::string source);

  /// The text with everything filled in. Throws YamlError.
  std::string fill(const YAML::Node& scalar) const;

  /// What the node stands for: a text that is nothing but one `{table:key}` stands for the table's
  /// entry, whatever that is, everything else for itself. Throws YamlError.
  YAML::Node resolve(const YAML::Node& node) const;

  const std::string& source() const { return source_; }

  /// What stands in braces in the text: `to`, `pose:to`; as far as it can be read.
  static std::vector<std::string> namesIn(const std::string& text);

 private:
  std::string object(const std::string& key, const YAML::Node& node) const;
  YAML::Node entry(const std::string& name, const YAML::Node& node) const;
  std::string value(const std::string& name, const YAML::Node& node) const;

  std::map<std::string, std::string> objects_;
  YAML::Node tables_;
  std::string source_;
};

}  // namespace goal_alignment::any_message
