// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/common/exceptions.h"

/// What all readers of YAML files share, for sources that link yaml-cpp.
namespace goal_alignment {

/// A text that is not what its reader expects; what() is `name:line:column: expected …, found …`.
class YamlError : public Exception {
 public:
  using Exception::Exception;
};

/// Reads a text that a person wrote, and knows for its errors where everything stands. All of it
/// throws YamlError.
class YamlReader {
 public:
  /// `source_name` is what errors call the text.
  explicit YamlReader(std::string source_name) : source_name_(std::move(source_name)) {}

  /// Gives `take` the one document of the text, unless there is nothing in it. What yaml-cpp throws
  /// meanwhile becomes a YamlError. O(text).
  void load(const std::string& text, const std::function<void(const YAML::Node&)>& take) const;

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& expected,
                         const std::string& found) const;
  [[noreturn]] void failAt(const YAML::Mark& mark, const std::string& message) const;
  /// `name:line:column`.
  std::string place(const YAML::Mark& mark) const;

  void expectMap(const YAML::Node& node, const std::string& what) const;
  void expectList(const YAML::Node& node, const std::string& what) const;

  /// The entries of a map, each of which must be one of `known` and stand there once; one that is
  /// left empty counts as not there.
  using Fields = std::map<std::string, YAML::Node>;
  Fields fields(const YAML::Node& node, const std::string& what,
                const std::vector<std::string>& known) const;

  /// A scalar that is not empty, of at most 1000 bytes of UTF-8, which a person may have to read.
  std::string text(const YAML::Node& node, const std::string& what) const;

  /// A number from `low` to `high`; `.inf` where `high` is that.
  double number(const YAML::Node& node, const std::string& what, double low, double high) const;

  /// `a map`, `a list`, `'text'` or `nothing`.
  static std::string describe(const YAML::Node& node);

 private:
  void refuseSecondDocument(const std::string& text) const;

  std::string source_name_;
};

}  // namespace goal_alignment
