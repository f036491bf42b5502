// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/candidates_alone.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "parts.h"
#include "samples.h"

namespace goal_alignment::achievability {
namespace {

using oracles::Hagl;
using samples::Parts;

RC_GTEST_PROP(CandidatesAlone, EqualBruteForceAndAreRemembered, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  Parts parts(hagl);
  const std::vector<Check> checks = parts.alone.checkAll({});
  RC_ASSERT(checks.size() == hagl.size());
  for (std::size_t f = 0; f < hagl.size(); ++f) {
    const bool possible = hagl.achievableAlone(f);
    RC_ASSERT(checks[f].verdict == (possible ? Verdict::Achievable : Verdict::Unachievable));
    RC_ASSERT(parts.alone.recall(f) == checks[f].verdict);
  }
  const std::size_t calls = parts.planner.calls();
  parts.alone.checkAll({});
  RC_ASSERT(parts.planner.calls() == calls);
}

RC_GTEST_PROP(CandidatesAlone, AreRecalledFromTheReachableStates, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  SearchBudget budget;
  if (oracles::chance(random, 0.5)) budget.first_symbolic = 1;
  Parts parts(hagl, budget);
  RC_ASSERT(parts.reachable.sweep({}) == LimitReason::None);
  for (std::size_t f = 0; f < hagl.size(); ++f) {
    RC_ASSERT(parts.alone.recall(f) ==
              (hagl.achievableAlone(f) ? Verdict::Achievable : Verdict::Unachievable));
  }
}

TEST(CandidatesAlone, SayWhichLimitLeftThemUnknown) {
  RandomSource random(5);
  const Hagl hagl = oracles::randomDisputedHagl(random);
  Parts parts(hagl);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  const std::vector<Check> checks = parts.alone.checkAll(limits);
  for (std::size_t f = 0; f < checks.size(); ++f) {
    const bool known = parts.alone.recall(f).has_value();
    EXPECT_EQ(checks[f].verdict == Verdict::Unknown, !known);
    EXPECT_EQ(checks[f].limit, known ? LimitReason::None : LimitReason::Cancelled);
  }
}

}  // namespace
}  // namespace goal_alignment::achievability
