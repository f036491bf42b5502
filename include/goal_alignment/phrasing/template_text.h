// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace goal_alignment::phrasing {

/// A text with numbered gaps, "{0} is made with {1}". `{{` and `}}` stand for the braces
/// themselves.
class TemplateText {
 public:
  /// Throws std::invalid_argument `expected …, found …` for a brace that makes no gap.
  static TemplateText parse(const std::string& text);

  /// The text with its gaps filled; nothing when it has a gap that `arguments` can't fill.
  std::optional<std::string> fill(const std::vector<std::string>& arguments) const;

 private:
  struct Piece {
    std::string text;                  ///< before the gap
    std::optional<std::size_t> index;  ///< of the argument; nothing: the text's end
  };
  std::vector<Piece> pieces_;
};

}  // namespace goal_alignment::phrasing
