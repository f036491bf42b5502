// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace goal_alignment {

/// "a, b, c": the texts that `text_of` gives of the elements, as people read a list. Nothing for an
/// empty range.
template <typename Range, typename TextOf>
std::string listed(const Range& range, TextOf text_of) {
  std::string text;
  bool first = true;
  for (const auto& element : range) {
    if (!first) text += ", ";
    first = false;
    text += text_of(element);
  }
  return text;
}

/// The same for elements with a method text(): literals, atoms, ground actions.
template <typename Range>
std::string listed(const Range& range) {
  return listed(range, [](const auto& element) { return element.text(); });
}

}  // namespace goal_alignment
