// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/conflict_minimiser.h"

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

// The members of a pair that no state has may be out of reach one by one.
RC_GTEST_PROP(ConflictMinimiser, ASmallConflictIsMinimalWhereTheBudgetsSuffice, ()) {
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

RC_GTEST_PROP(ConflictMinimiser, ShrinksWhatIsUnachievableToAMinimalConflict, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const std::set<CandidateBits> minimal = hagl.minimalConflicts();
  Parts parts(hagl);
  for (int i = 0; i < 5; ++i) {
    const CandidateBits bits = random.below(hagl.all() + 1);
    if (hagl.achievable(bits)) continue;
    const CandidateSet set = setOf(hagl.size(), bits);
    parts.minimiser.learnUnachievable(set, {});
    RC_ASSERT(parts.knowledge.provenConflictWithin(set) != nullptr);
    const Conflict* small = parts.minimiser.smallConflictWithin(set, {});
    RC_ASSERT(small != nullptr && small->proven && small->members.is_subset_of(set));
    RC_ASSERT(minimal.count(small->members.to_ulong()) == 1U);
  }
}

// Minimising has its budget once a conflict: what that left open is not searched for again.
RC_GTEST_PROP(ConflictMinimiser, TestsAConflictOnce, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const CandidateSet all = setOf(hagl.size(), hagl.all());
  Parts parts(hagl);
  const bool any = parts.minimiser.smallConflictWithin(all, {}) != nullptr;
  const std::size_t calls = parts.planner.calls();
  RC_ASSERT((parts.minimiser.smallConflictWithin(all, {}) != nullptr) == any);
  RC_ASSERT(parts.planner.calls() == calls);
}

}  // namespace
}  // namespace goal_alignment::achievability
