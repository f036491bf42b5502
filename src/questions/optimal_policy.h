// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "expected_cost.h"
#include "goal_alignment/common/random_source.h"
#include "goal_alignment/questions/policy.h"
#include "live_conflict.h"
#include "ratio_policy.h"

namespace goal_alignment::questions {

/// Minimises the expected number of questions where that can be computed within the work allowed
/// for one decision and at most 64 candidates matter. Otherwise asks as RatioPolicy does or, where
/// it is likely that the answers hit all conflicts, what leaves the least uncertainty about that.
/// Work is counted, not timed, so that a seed replays.
class OptimalPolicy : public Policy {
 public:
  /// About a second.
  static constexpr std::uint64_t kWork = 100'000'000;

  explicit OptimalPolicy(const PolicyContext& context, std::uint64_t work = kWork)
      : work_(work), poll_(context.poll), random_(context.seed), ratio_(context) {}
  std::optional<Choice> next(const Situation& situation) override;
  bool usesConflicts() const override { return true; }

 private:
  bool assignBits(const std::vector<LiveConflict>& live, const Situation& situation);
  MonotoneDnf dnfOf(const std::vector<LiveConflict>& live) const;
  Choice choiceOf(CandidateMask set, const Situation& situation);

  std::uint64_t work_;
  std::function<void()> poll_;
  RandomSource random_;
  RatioPolicy ratio_;
  // Each candidate that was ever open in a live conflict keeps its bit, so that what cost_
  // remembers stays valid when conflicts are hit or found.
  std::vector<std::size_t> candidate_of_;
  std::map<std::size_t, std::size_t> bit_of_;
  std::optional<ExpectedCost> cost_;
};

}  // namespace goal_alignment::questions
