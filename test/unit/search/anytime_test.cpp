// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/anytime.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "goal_alignment/search/greedy.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"
#include "samples.h"

namespace goal_alignment::search {
namespace {

using task::Task;

RC_GTEST_PROP(Anytime, EndsWithAnOptimalPlan, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const Result first = greedy(*samples::packed(task), goal, {});
  RC_PRE(first.status == Status::Solved);
  const Improved improved = improve(*samples::packed(task), goal, first.plan, {});
  RC_ASSERT(improved.optimal);
  RC_ASSERT(improved.cost == oracles::optimalCost(task, oracles::initialFacts(task), goal).value());
  const auto end = oracles::execute(task, improved.plan);
  RC_ASSERT(end && oracles::holds(goal, *end));
  RC_ASSERT(task::cost(task, improved.plan) == improved.cost);
}

// Whatever ends it, the plan is one, and never dearer than before.
RC_GTEST_PROP(Anytime, ALimitLeavesTheBestPlanSoFar, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const Result first = greedy(*samples::packed(task), goal, {});
  RC_PRE(first.status == Status::Solved);
  const Improved improved =
      improve(*samples::packed(task), goal, first.plan, Limits{}.withStates(random.below(20)));
  RC_ASSERT(improved.cost <= first.cost);
  RC_ASSERT(improved.optimal == (improved.limit == LimitReason::None));
  if (improved.optimal) {
    RC_ASSERT(improved.cost ==
              oracles::optimalCost(task, oracles::initialFacts(task), goal).value());
  }
  const auto end = oracles::execute(task, improved.plan);
  RC_ASSERT(end && oracles::holds(goal, *end));
}

RC_GTEST_PROP(Weighted, FindsWhatIsCheaperThanTheBound, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const auto best = oracles::optimalCost(task, oracles::initialFacts(task), goal);
  const auto bound = static_cast<task::Cost>(random.below(8));
  const Result result = weighted(*samples::packed(task), goal, {}, 2, bound);
  RC_ASSERT(result.status == (best && *best < bound ? Status::Solved : Status::Unsolvable));
  if (result.status != Status::Solved) return;
  RC_ASSERT(result.cost < bound);
  RC_ASSERT(samples::valid(task, goal, result));
}

TEST(Anytime, ACancelEndsItAtOnce) {
  const Task task = samples::switches(12);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  const Improved improved = improve(*samples::packed(task), task::FactSet{1}, {0}, limits);
  EXPECT_EQ(improved.limit, LimitReason::Cancelled);
  EXPECT_EQ(improved.plan, task::Plan{0});
  EXPECT_FALSE(improved.optimal);
}

}  // namespace
}  // namespace goal_alignment::search
