// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/reachable_states.h"

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

using oracles::CandidateBits;
using oracles::Hagl;
using samples::Parts;
using samples::setOf;

/// Sweeps that end in one form each.
SearchBudget diagramBudget() {
  SearchBudget budget;
  budget.first_symbolic = 100'000'000;
  return budget;
}
SearchBudget enumerationBudget() {
  SearchBudget budget;
  budget.first_symbolic = 1;
  return budget;
}

RC_GTEST_PROP(ReachableStates, TheDiagramEqualsBruteForce, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random, 7);
  RC_LOG() << samples::text(hagl);
  Parts parts(hagl, diagramBudget());
  RC_ASSERT(parts.reachable.sweepIsDue({}));
  RC_ASSERT(parts.reachable.sweep({}) == LimitReason::None);
  RC_ASSERT(parts.planner.calls() == 1U);
  RC_ASSERT(parts.reachable.haveDiagram() && !parts.reachable.enumerated());
  RC_ASSERT(!parts.reachable.sweepIsDue({}));
  for (CandidateBits bits = 0; bits <= hagl.all(); ++bits) {
    const CandidateSet set = setOf(hagl.size(), bits);
    if (parts.knowledge.provenConflictWithin(set) != nullptr) continue;
    const task::Goal goal = parts.task.goalWith(set);
    RC_ASSERT(parts.reachable.satisfy(goal) == hagl.achievable(bits));
    RC_ASSERT(parts.reachable.planFor(goal, {}).has_value() == hagl.achievable(bits));
  }
}

// Of candidates that no fact stands for, the conflicts are known before.
RC_GTEST_PROP(ReachableStates, TheDiagramListsTheMinimalConflicts, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  Parts parts(hagl, diagramBudget());
  RC_ASSERT(parts.reachable.sweep({}) == LimitReason::None);
  const auto found = parts.reachable.minimalConflicts({});
  RC_ASSERT(found.has_value());
  parts.knowledge.learnAllConflicts(*found);
  std::set<CandidateBits> conflicts;
  for (const Conflict& conflict : parts.knowledge.conflicts())
    conflicts.insert(conflict.members.to_ulong());
  RC_ASSERT(conflicts == hagl.minimalConflicts());
}

RC_GTEST_PROP(ReachableStates, AnEnumerationFindsEveryAchievedSet, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  Parts parts(hagl, enumerationBudget());
  RC_ASSERT(parts.reachable.sweep({}) == LimitReason::None);
  if (parts.reachable.haveDiagram()) return;  // there is nothing to compute
  RC_ASSERT(parts.reachable.enumerated());
  for (CandidateBits bits = 0; bits <= hagl.all(); ++bits) {
    const CandidateSet set = setOf(hagl.size(), bits);
    RC_ASSERT(parts.knowledge.hasPlanFor(set) == hagl.achievable(bits));
  }
}

// Our own budgets would end it again; a cancel would not.
TEST(ReachableStates, AreSweptAgainAfterACancelOnly) {
  SearchBudget budget;
  budget.first_symbolic = budget.exhaustive = budget.symbolic = 0;
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  int ended_by_budget = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomSource random(seed);
    Parts parts(oracles::randomDisputedHagl(random), budget);
    if (parts.reachable.sweep(limits) == LimitReason::Cancelled) {
      EXPECT_TRUE(parts.reachable.sweepIsDue({}));
    }
    const LimitReason limit = parts.reachable.sweep({});
    EXPECT_EQ(parts.reachable.sweepLimit(), limit);
    EXPECT_FALSE(parts.reachable.sweepIsDue({}));
    if (limit == LimitReason::None) continue;  // there was nothing to compute
    EXPECT_EQ(limit, LimitReason::States);
    EXPECT_FALSE(parts.reachable.haveDiagram() || parts.reachable.enumerated());
    ++ended_by_budget;
  }
  EXPECT_GT(ended_by_budget, 0);
}

}  // namespace
}  // namespace goal_alignment::achievability
