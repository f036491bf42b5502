// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/goal_set_prover.h"

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
using samples::make;
using samples::Parts;
using samples::requireSound;
using samples::setOf;

RC_GTEST_PROP(GoalSetProver, SaysUnknownRatherThanGuess, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const SearchBudget budget = {random.below(4), random.below(4), random.below(4), random.below(4),
                               random.below(4)};
  const auto robot = make(hagl, budget);
  for (int i = 0; i < 30; ++i) {
    const CandidateBits set = random.below(hagl.all() + 1);
    const Check check = robot->check(setOf(hagl.size(), set), {});
    if (check.verdict == Verdict::Unknown) {
      RC_ASSERT(check.limit == LimitReason::States);
      if (oracles::chance(random, 0.5)) robot->suspect(setOf(hagl.size(), set));
    } else {
      RC_ASSERT((check.verdict == Verdict::Achievable) == hagl.achievable(set));
    }
  }
  requireSound(hagl, *robot);
}

// Checks in any order, as a lazy dialogue makes them, suspicions and all: right where they say
// something, and none of it is in the way of the rest.
RC_GTEST_PROP(GoalSetProver, LazyChecksAgreeWithBruteForce, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  SearchBudget budget = {random.below(20), 1, 1, 1, random.below(40)};
  budget.shrinking = random.below(20);
  budget.parts = oracles::chance(random, 0.5) ? random.below(30) : 100'000;
  const auto robot = make(hagl, budget);
  for (int i = 0; i < 20; ++i) {
    const CandidateBits bits = random.below(hagl.all() + 1);
    const CandidateSet set = setOf(hagl.size(), bits);
    const Check check = robot->check(set, {});
    const auto& known = robot->conflicts();
    const bool suspected = std::any_of(known.begin(), known.end(), [&](const Conflict& conflict) {
      return conflict.members.is_subset_of(set);
    });
    if (check.verdict == Verdict::Unknown) {
      RC_ASSERT(suspected);
    } else {
      RC_ASSERT((check.verdict == Verdict::Achievable) == hagl.achievable(bits));
      RC_ASSERT(suspected != hagl.achievable(bits));
    }
    requireSound(hagl, *robot);
  }
}

// Each budget leaves one stage that can answer.
RC_GTEST_PROP(GoalSetProver, TheFirstStageWhoseBudgetSufficesAnswers, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const CandidateBits bits = random.below(hagl.all() + 1);
  const CandidateSet set = setOf(hagl.size(), bits);
  for (const SearchBudget& budget : samples::stageBudgets()) {
    Parts parts(hagl, budget);
    if (parts.knowledge.recall(set)) return;  // no stage is needed
    const Check check = parts.prover.check(set, {});
    // It did not come to a sweep where the search before it suffices.
    if (budget.first_greedy >= 20'000) RC_ASSERT(parts.reachable.sweepIsDue({}));
    if (check.verdict == Verdict::Unknown) continue;
    RC_ASSERT((check.verdict == Verdict::Achievable) == hagl.achievable(bits));
    const std::size_t calls = parts.planner.calls();
    RC_ASSERT(parts.prover.check(set, {}).verdict == check.verdict);
    RC_ASSERT(parts.planner.calls() == calls);  // from memory
  }
}

RC_GTEST_PROP(GoalSetProver, ACancelLeavesNoSuspicion, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  Parts parts(hagl);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  const Check check = parts.prover.check(setOf(hagl.size(), hagl.all()), limits);
  if (check.verdict == Verdict::Unknown) RC_ASSERT(check.limit == LimitReason::Cancelled);
  for (const Conflict& conflict : parts.knowledge.conflicts())
    RC_ASSERT(conflict.proven);
}

}  // namespace
}  // namespace goal_alignment::achievability
