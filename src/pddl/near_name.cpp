// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/near_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::pddl {

namespace {

/// Whoever writes longer names does not mistype them.
constexpr std::size_t kLongestName = 60;

/// Single-letter slips between two names: one too many, one missing, one wrong, two swapped
/// (Damerau and Levenshtein's distance, of which only the last three rows are held).
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string suggestion(std::string_view wanted, const std::vector<std::string>& known) {
  if (wanted.size() > kLongestName) return {};
  const std::string lower = toLower(wanted);
  // One slip in every three letters is the most that still looks like the same name: of one or two
  // letters (a, b, c1) nearly everything would be near.
  std::size_t nearest = lower.size() / 3 + 1;
  const std::string* best = nullptr;
  for (const std::string& name : known) {
    if (name.size() > lower.size() + nearest || lower.size() > name.size() + nearest) continue;
    const std::size_t distance = editDistance(lower, toLower(name));
    if (distance < nearest || (distance == nearest && best != nullptr && name < *best)) {
      nearest = distance;
      best = &name;
    }
  }
  return best == nullptr ? "" : "; did you mean " + inQuotes(*best) + "?";
}

}  // namespace goal_alignment::pddl
