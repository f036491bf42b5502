// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace goal_alignment {

/// The name of something ground: an atom such as `(on a b)` or an action such as `(stack a b)`.
///
/// Names match without case (PDDL 1.2, section 3), so a GroundName is always held in lower case;
/// the spelling that a person reads comes from pddl::Model::spelling().
struct GroundName {
  std::string name;                    ///< predicate or action schema, lower case
  std::vector<std::string> arguments;  ///< objects, lower case

  /// `(name arg1 arg2)`, the one textual form used across layers (JSON, plans, maps).
  std::string text() const;

  /// Reads `(name arg …)` or `name arg …`, in any case. An empty or unbalanced text throws
  /// std::invalid_argument that quotes its beginning.
  static GroundName parse(std::string_view text);

  friend bool operator==(const GroundName& a, const GroundName& b) {
    return a.name == b.name && a.arguments == b.arguments;
  }
  friend bool operator!=(const GroundName& a, const GroundName& b) { return !(a == b); }
  friend bool operator<(const GroundName& a, const GroundName& b) {
    return std::tie(a.name, a.arguments) < std::tie(b.name, b.arguments);
  }
};

/// A ground atom or its negation.
struct Literal {
  GroundName atom;
  bool negated = false;

  /// `(on a b)` or `(not (on a b))`.
  std::string text() const;

  /// The inverse of text(); throws std::invalid_argument.
  static Literal parse(std::string_view text);

  friend bool operator==(const Literal& a, const Literal& b) {
    return a.negated == b.negated && a.atom == b.atom;
  }
  friend bool operator!=(const Literal& a, const Literal& b) { return !(a == b); }
  friend bool operator<(const Literal& a, const Literal& b) {
    return std::tie(a.atom, a.negated) < std::tie(b.atom, b.negated);
  }
};

/// ASCII lower case, and other letters as they are: a locale must not change what matches.
std::string toLower(std::string_view text);

/// The text without the blanks and line ends around it; a part of the same text.
std::string_view trimmed(std::string_view text);

}  // namespace goal_alignment

template <>
struct std::hash<goal_alignment::GroundName> {
  std::size_t operator()(const goal_alignment::GroundName& ground) const noexcept;
};
