// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/conflict_enumeration.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "parts.h"
#include "samples.h"

namespace goal_alignment::achievability {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::make;
using samples::provenConflicts;
using samples::requireSound;
using samples::setOf;

RC_GTEST_PROP(ConflictEnumeration, FindsExactlyTheMinimalConflicts, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const std::set<CandidateBits> expected = hagl.minimalConflicts();
  for (SearchBudget budget : samples::stageBudgets()) {
    if (budget.second_greedy == 1) budget.first_greedy = 1'000'000;
    const auto robot = make(hagl, budget);
    RC_ASSERT(!robot->complete());
    RC_ASSERT(robot->findAllConflicts({}));
    RC_ASSERT(robot->complete());
    RC_ASSERT(provenConflicts(*robot) == expected);
    RC_ASSERT(robot->conflicts().size() == expected.size());
    for (const Conflict& conflict : robot->conflicts())
      RC_ASSERT(conflict.minimal);
  }
}

// Whatever the number of threads: the same conflicts in the same order, by the same plans.
RC_GTEST_PROP(ConflictEnumeration, ThreadsChangeNothing, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  SearchBudget budget = {1 + random.below(50), 1, 1, 1, 1 + random.below(50), 1};
  const auto alone = make(hagl, budget);
  alone->findAllConflicts({});
  budget.threads = 4;
  const auto together = make(hagl, budget);
  together->findAllConflicts({});
  RC_ASSERT(alone->plannerCalls() == together->plannerCalls());
  RC_ASSERT(alone->conflicts().size() == together->conflicts().size());
  for (std::size_t i = 0; i < alone->conflicts().size(); ++i)
    RC_ASSERT(alone->conflicts()[i].members == together->conflicts()[i].members);
  RC_ASSERT(alone->achieved().size() == together->achieved().size());
  for (std::size_t i = 0; i < alone->achieved().size(); ++i)
    RC_ASSERT(alone->achieved()[i].plan == together->achieved()[i].plan);
}

RC_GTEST_PROP(ConflictEnumeration, IsSoundWithTinyBudgets, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  SearchBudget budget = {random.below(6), random.below(6), random.below(6), random.below(6),
                         random.below(6)};
  budget.shrinking = random.below(6);
  budget.parts = random.below(30);
  const auto robot = make(hagl, budget);
  const bool complete = robot->findAllConflicts({});
  RC_ASSERT(complete == robot->complete());
  requireSound(hagl, *robot);
  // Nothing is left over: what holds no conflict known or suspected was achieved by a plan.
  for (CandidateBits set = 0; set <= hagl.all(); ++set) {
    const bool free = std::none_of(robot->conflicts().begin(), robot->conflicts().end(),
                                   [&](const Conflict& conflict) {
                                     return conflict.members.is_subset_of(setOf(hagl.size(), set));
                                   });
    if (free) RC_ASSERT(hagl.achievable(set));
  }
}

// However few sets it may look at in one call.
RC_GTEST_PROP(ConflictEnumeration, ResumesWhereItLeftOff, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  SearchBudget budget = {random.below(10), 1, 1, 1, 1'000'000};
  budget.open_sets = 1;
  const auto robot = make(hagl, budget);
  std::size_t calls = 0;
  while (!robot->findAllConflicts({})) {
    requireSound(hagl, *robot);
    RC_ASSERT(++calls <= hagl.all() + 1);
  }
  RC_ASSERT(provenConflicts(*robot) == hagl.minimalConflicts());
}

// After a cancel a session resumes with everything it had learnt, and nothing is spoilt.
RC_GTEST_PROP(ConflictEnumeration, ResumesAfterACancel, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const SearchBudget budget = {random.below(10), 1, 1'000'000, 1, random.below(10)};
  const auto robot = make(hagl, budget);
  CancelToken token;
  Limits limits;
  limits.cancel = &token;
  token.cancel();
  robot->findAllConflicts(limits);
  requireSound(hagl, *robot);
  token.reset();
  RC_ASSERT(robot->findAllConflicts(limits));
  RC_ASSERT(provenConflicts(*robot) == hagl.minimalConflicts());
}

RC_GTEST_PROP(ConflictEnumeration, SuspicionsAreClearedByPlans, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const auto robot = make(hagl);
  for (int i = 0; i < 3; ++i) {
    const CandidateBits set = random.below(hagl.all() + 1);
    if (robot->provenConflictWithin(setOf(hagl.size(), set)) == nullptr) {
      robot->suspect(setOf(hagl.size(), set));
    }
  }
  // Suspicions hide nothing for good: each is either proven in the end or gone.
  for (CandidateBits set = 0; set <= hagl.all(); ++set)
    robot->check(setOf(hagl.size(), set), {});
  RC_ASSERT(robot->findAllConflicts({}));
  RC_ASSERT(provenConflicts(*robot) == hagl.minimalConflicts());
}

// Where the reachable states are at hand as a diagram, no set needs a check.
RC_GTEST_PROP(ConflictEnumeration, ListsThemFromADiagramWithoutASearch, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  SearchBudget budget;
  budget.first_symbolic = 100'000'000;
  samples::Parts parts(hagl, budget);
  RC_ASSERT(parts.reachable.sweep({}) == LimitReason::None);
  const std::size_t calls = parts.planner.calls();
  RC_ASSERT(parts.enumeration.run({}) == LimitReason::None);
  RC_ASSERT(parts.knowledge.complete());
  RC_ASSERT(parts.planner.calls() == calls);
  std::set<CandidateBits> found;
  for (const Conflict& conflict : parts.knowledge.conflicts()) {
    RC_ASSERT(conflict.proven && conflict.minimal);
    found.insert(conflict.members.to_ulong());
  }
  RC_ASSERT(found == hagl.minimalConflicts());
}

TEST(ConflictEnumeration, SaysThatTheNumberOfSetsEndedIt) {
  RandomSource random(5);
  const Hagl hagl = oracles::randomDisputedHagl(random);
  SearchBudget budget;
  budget.open_sets = 0;
  samples::Parts parts(hagl, budget);
  EXPECT_EQ(parts.enumeration.run({}), LimitReason::States);
  EXPECT_FALSE(parts.knowledge.complete());
  EXPECT_EQ(parts.planner.calls(), 0U);
}

TEST(ConflictEnumeration, SaysThatACancelEndedIt) {
  RandomSource random(5);
  const Hagl hagl = oracles::randomDisputedHagl(random);
  samples::Parts parts(hagl);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_EQ(parts.enumeration.run(limits), LimitReason::Cancelled);
  EXPECT_FALSE(parts.knowledge.complete());
}

}  // namespace
}  // namespace goal_alignment::achievability
