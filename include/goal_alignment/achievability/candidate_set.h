// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/dynamic_bitset.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace goal_alignment::achievability {

/// A set of candidates, by their index.
using CandidateSet = boost::dynamic_bitset<std::uint64_t>;

/// The indices in the set in ascending order.
inline std::vector<std::size_t> members(const CandidateSet& set) {
  std::vector<std::size_t> result;
  for (std::size_t i = set.find_first(); i != CandidateSet::npos; i = set.find_next(i)) {
    result.push_back(i);
  }
  return result;
}

/// A set of candidates that cannot be had together with the specified goal.
struct Conflict {
  CandidateSet members;
  bool proven = true;    ///< false: suspected, since the limits left it undecided
  bool minimal = false;  ///< proven that every proper subset can be had
};

}  // namespace goal_alignment::achievability
