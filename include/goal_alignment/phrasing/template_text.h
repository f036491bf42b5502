// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace goal_alignment::phrasing {

/// What fills a gap: a text, and how it reads in the forms that a language has, "dem Tisch".
struct Filling {
  std::string text;
  std::map<std::string, std::string> forms;

  /// `form` may be empty; one that it does not have reads as the text.
  const std::string& in(const std::string& form) const;
};

/// A text with numbered gaps, "{0} is made with {1}", each maybe in a form, "{0:dative}". `{{` and
/// `}}` stand for the braces themselves.
class TemplateText {
 public:
  /// Throws std::invalid_argument `expected …, found …` for a brace that makes no gap.
  static TemplateText parse(const std::string& text);

  /// The text with its gaps filled; nothing when it has a gap that `arguments` can't fill.
  std::optional<std::string> fillIn(const std::vector<Filling>& arguments) const;
  std::optional<std::string> fill(const std::vector<std::string>& arguments) const;

  std::set<std::size_t> gaps() const;

 private:
  struct Piece {
    std::string text;                  ///< before the gap
    std::optional<std::size_t> index;  ///< of the argument; nothing: the text's end
    std::string form;
  };
  static void readGap(const std::string& text, std::size_t& open, Piece& piece);

  std::vector<Piece> pieces_;
};

}  // namespace goal_alignment::phrasing
