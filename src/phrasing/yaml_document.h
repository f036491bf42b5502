// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>

#include "goal_alignment/phrasing/template_text.h"

namespace goal_alignment::phrasing {

/// Reads a YAML text and knows, for its errors, where everything stands. All faults are
/// PhraseError.
class YamlDocument {
 public:
  explicit YamlDocument(std::string source_name) : source_name_(std::move(source_name)) {}

  /// Calls `treat` with the one document in the text, unless there is nothing in it.
  template <typename Treat>
  void read(const std::string& text, Treat treat) const {
    try {
      refuseSecondDocument(text);
      const YAML::Node document = YAML::Load(text);
      if (!document.IsNull()) treat(document);
    } catch (const YAML::Exception& exception) {  // also while it is treated
      failAsYaml(exception);
    }
  }

  /// "expected …, found …".
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& expected,
                         const std::string& found) const;
  [[noreturn]] void failAt(const YAML::Mark& mark, const std::string& message) const;

  void expectMap(const YAML::Node& node, const std::string& what) const;
  void expectList(const YAML::Node& node, const std::string& what) const;

  /// Not empty, not long, UTF-8.
  std::string text(const YAML::Node& node, const std::string& what) const;
  TemplateText sentence(const YAML::Node& node, const std::string& what) const;

  /// "a map", "a list", "nothing", or the text in quotes.
  static std::string describe(const YAML::Node& node);

 private:
  void refuseSecondDocument(const std::string& text) const;
  [[noreturn]] void failAsYaml(const YAML::Exception& exception) const;

  std::string source_name_;
};

}  // namespace goal_alignment::phrasing
