// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"

namespace goal_alignment::achievability {

/// The set without members that it can do without: `holds(rest)` says whether the rest still has
/// the property looked for. Tries to leave out large pieces first, then smaller ones, and in the
/// end single members, so that the result is minimal where the property is monotone.
/// O(result · log set) calls that say no, O(log set) that say yes where the result is small.
template <typename Holds>
CandidateSet shrunk(CandidateSet set, Holds&& holds) {
  std::size_t piece = std::max<std::size_t>(set.count() / 2, 1);
  for (;; piece /= 2) {
    const std::vector<std::size_t> all = members(set);
    for (std::size_t begin = 0; begin < all.size(); begin += piece) {
      CandidateSet rest = set;
      for (std::size_t i = begin; i < std::min(begin + piece, all.size()); ++i)
        rest.reset(all[i]);
      if (holds(rest)) set = std::move(rest);
    }
    if (piece <= 1) return set;
  }
}

}  // namespace goal_alignment::achievability
