// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/common/limits.h"

namespace goal_alignment::achievability {

/// Which sets of candidates are still unexplored: the map of MARCO (Liffiton, Previti, Malik &
/// Marques-Silva, "Fast, flexible MUS enumeration", Constraints 2016), a formula with one variable
/// per candidate whose models are these sets. Deterministic.
///
///     SubsetMap map(candidates);
///     for (;;) {
///       const auto found = map.maximal(1, limits);
///       if (found.sets.empty()) break;                 // explored, unless found.limit says why
///       if (can be had) map.blockDown(found.sets[0]); else map.blockUp(a conflict within it);
///     }
class SubsetMap {
 public:
  explicit SubsetMap(std::size_t candidates);
  SubsetMap(SubsetMap&&) noexcept;
  ~SubsetMap();

  /// Explores the set and all that contain it. O(set).
  void blockUp(const CandidateSet& conflict);
  /// Explores the set and all within it. O(candidates).
  void blockDown(const CandidateSet& achieved);

  struct Unexplored {
    std::vector<CandidateSet> sets;         ///< fewer than were wanted: there are no others
    LimitReason limit = LimitReason::None;  ///< why there may be others
  };

  /// Up to `max_sets` unexplored sets of which every proper superset is explored. They stay
  /// unexplored. One call of a SAT solver each: NP-hard, quick in practice. Reads the clock, the
  /// cancel token and the bytes of the limits, not the states.
  Unexplored maximal(std::size_t max_sets, const Limits& limits);

  /// About what the blocks take. The solver keeps small by itself what it learns from them.
  std::size_t bytes() const { return bytes_; }

 private:
  class Solver;

  CandidateSet grown(CandidateSet set) const;
  void add(const std::vector<int>& clause);

  std::size_t candidates_;
  std::size_t bytes_ = 0;
  std::vector<CandidateSet> blocked_up_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace goal_alignment::achievability
