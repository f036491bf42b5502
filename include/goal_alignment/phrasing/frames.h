// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/phrasing/template_text.h"

/// The texts around the clauses: all of a question, a reason or an outcome that does not come from
/// the models. config/phrases/en.yaml has them all and says what they are for; other languages have
/// the same names.
namespace goal_alignment::phrasing {

class Frames {
 public:
  using Shared = std::shared_ptr<const Frames>;

  static const Shared& english();

  /// One of the languages of config/phrases, such as "de"; null: it is not among them.
  static Shared shipped(const std::string& language);
  static std::vector<std::string> shippedLanguages();

  /// Throws YamlError, whose what() is `name:line:column: expected …, found …`, for a name that
  /// there isn't and a text without a gap that it must have. What is missing is said as `base` says
  /// it. O(text).
  static Shared fromYaml(const std::string& text, const std::string& source_name,
                         const Frames& base = *english());

  /// The names that its file did not have.
  const std::set<std::string>& missing() const { return missing_; }

  /// The text called `name`, its gaps filled. Throws std::out_of_range where there is none.
  std::string fill(const std::string& name, const std::vector<std::string>& arguments = {}) const;

  /// The same where `name` has a form of its own for 1, `name`_one. The number is the first gap's.
  std::string counted(const std::string& name, std::size_t number,
                      std::vector<std::string> more = {}) const;

 private:
  friend class FramesReader;

  std::map<std::string, TemplateText> texts_;
  std::set<std::string> missing_;
};

}  // namespace goal_alignment::phrasing
