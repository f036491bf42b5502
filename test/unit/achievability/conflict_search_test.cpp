// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "goal_alignment/achievability/achievability.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

namespace goal_alignment::achievability {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::make;
using samples::provenConflicts;
using samples::setOf;

RC_GTEST_PROP(ConflictSearch, FindsExactlyTheMinimalConflicts, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const std::set<CandidateBits> expected = hagl.minimalConflicts();
  for (SearchBudget budget : samples::ways()) {
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
RC_GTEST_PROP(ConflictSearch, ThreadsChangeNothing, ()) {
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

/// What is known must be so, however little was searched.
void requireSound(const Hagl& hagl, const Achievability& robot) {
  const std::set<CandidateBits> minimal = hagl.minimalConflicts();
  for (const Conflict& conflict : robot.conflicts()) {
    const CandidateBits set = conflict.members.to_ulong();
    if (conflict.proven) RC_ASSERT(!hagl.achievable(set));
    if (conflict.minimal) RC_ASSERT(conflict.proven && minimal.count(set) > 0);
  }
  for (const auto& achieved : robot.achieved())
    RC_ASSERT(hagl.achievable(achieved.set.to_ulong()));
  if (robot.complete()) RC_ASSERT(provenConflicts(robot) == minimal);
}

RC_GTEST_PROP(ConflictSearch, IsSoundWithTinyBudgets, ()) {
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

RC_GTEST_PROP(ConflictSearch, SaysUnknownRatherThanGuess, ()) {
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

// However few sets it may look at in one call.
RC_GTEST_PROP(ConflictSearch, GoesOnWhereItLeftOff, ()) {
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

// Checks in any order, as a lazy dialogue makes them, suspicions and all: right where they say
// something, and none of it is in the way of the rest.
RC_GTEST_PROP(ConflictSearch, LazyChecksAgreeWithBruteForce, ()) {
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

// The members of a pair that no state has may be out of reach one by one.
RC_GTEST_PROP(ConflictSearch, ASmallConflictIsMinimalWhereTheBudgetsSuffice, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const std::set<CandidateBits> minimal = hagl.minimalConflicts();
  for (const bool plenty : {true, false}) {
    SearchBudget budget;
    if (!plenty) budget = {random.below(6), 1, 1, 1, random.below(6), 1, 1, 1};
    if (!plenty) budget.minimising = random.below(40);
    const auto robot = make(hagl, budget);
    for (int i = 0; i < 10; ++i) {
      const CandidateSet set = setOf(hagl.size(), random.below(hagl.all() + 1));
      if (oracles::chance(random, 0.3)) robot->check(set, {});
      const bool any = robot->provenConflictWithin(set) != nullptr;
      const Conflict* small = robot->smallConflictWithin(set, {});
      RC_ASSERT((small != nullptr) == any);
      if (!any) continue;
      RC_ASSERT(small->proven && small->members.is_subset_of(set));
      if (plenty) RC_ASSERT(small->minimal && minimal.count(small->members.to_ulong()) > 0);
      requireSound(hagl, *robot);
    }
  }
}

// A session goes on after a cancel, with everything it had learnt and nothing spoilt.
RC_GTEST_PROP(ConflictSearch, GoesOnAfterACancel, ()) {
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

RC_GTEST_PROP(ConflictSearch, SuspicionsAreClearedByPlans, ()) {
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

}  // namespace
}  // namespace goal_alignment::achievability
