// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/planner.h"

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

using search::Status;

RC_GTEST_PROP(Planner, EverySearchEqualsBruteForceAndIsCounted, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random, 7);
  RC_LOG() << samples::text(hagl);
  const GoalSetTask task(samples::grounded(hagl), hagl.specified, hagl.candidates, {});
  Planner planner(task, 1);
  std::size_t calls = 0;
  for (int i = 0; i < 5; ++i) {
    const CandidateBits bits = random.below(hagl.all() + 1);
    const CandidateSet set = setOf(hagl.size(), bits);
    if (task.conflicts().provenWithin(set) != nullptr) continue;  // no goal says it
    const Status expected = hagl.achievable(bits) ? Status::Solved : Status::Unsolvable;
    const search::Result any = planner.greedy(task.goalWith(set), {});
    const search::Result best = planner.optimal(set, {});
    RC_ASSERT(any.status == expected);
    RC_ASSERT(best.status == expected);
    RC_ASSERT(planner.inParts(set, {}).status == expected);
    RC_ASSERT(planner.calls() == (calls += 3));
    if (expected == Status::Unsolvable) continue;
    const search::Improved improved = planner.improve(set, any.plan, {});
    RC_ASSERT(improved.optimal && improved.cost == best.cost);
    RC_ASSERT(planner.calls() == ++calls);
  }
}

RC_GTEST_PROP(Planner, SideBySideIsOneAfterTheOther, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const GoalSetTask task(samples::grounded(hagl), hagl.specified, hagl.candidates, {});
  std::vector<task::Goal> goals;
  for (int i = 0; i < 6; ++i)
    goals.push_back(task.goalWith(setOf(hagl.size(), random.below(hagl.all() + 1))));
  Planner together(task, 4);
  Planner alone(task, 1);
  const Limits limits = Limits{}.withStates(random.below(50));
  const std::vector<search::Result> results = together.greedyForEach(goals, limits);
  RC_ASSERT(together.calls() == goals.size());
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const search::Result result = alone.greedy(goals[i], limits);
    RC_ASSERT(results[i].status == result.status);
    RC_ASSERT(results[i].plan == result.plan);
  }
}

TEST(Planner, CountsTheSweepsOfOthers) {
  RandomSource random(1);
  const Hagl hagl = oracles::randomHagl(random);
  const GoalSetTask task(samples::grounded(hagl), hagl.specified, hagl.candidates, {});
  Planner planner(task, 1);
  planner.countSweep();
  EXPECT_EQ(planner.calls(), 1U);
}

}  // namespace
}  // namespace goal_alignment::achievability
