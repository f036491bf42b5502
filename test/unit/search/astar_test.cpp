// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/astar.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"
#include "samples.h"

namespace goal_alignment::search {
namespace {

using task::Cost;
using task::Task;

RC_GTEST_PROP(AStar, FindsDijkstrasCost, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const auto best = oracles::optimalCost(task, oracles::initialFacts(task), goal);
  const Result result = astar(*samples::packed(task), goal, {});
  RC_ASSERT(result.status == (best ? Status::Solved : Status::Unsolvable));
  RC_ASSERT(result.limit == LimitReason::None);
  if (!best) return;
  RC_ASSERT(result.cost == *best);
  RC_ASSERT(samples::valid(task, goal, result));
}

RC_GTEST_PROP(AStar, AnUpperBoundHidesPlansThatCostAsMuch, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const auto best = oracles::optimalCost(task, oracles::initialFacts(task), goal);
  RC_PRE(best.has_value());
  RC_ASSERT(astar(*samples::packed(task), goal, {}, {0, *best}).status == Status::Unsolvable);
  const Result just = astar(*samples::packed(task), goal, {}, {*best, *best + 1});
  RC_ASSERT(just.status == Status::Solved);
  RC_ASSERT(just.cost == *best);
}

// Whatever the limit, the answer is the true one or none.
RC_GTEST_PROP(AStar, NeverMistakesALimitForAProof, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const auto best = oracles::optimalCost(task, oracles::initialFacts(task), goal);
  const std::uint64_t states = random.below(30);
  const Result result = astar(*samples::packed(task), goal, Limits{}.withStates(states));
  RC_ASSERT((result.status == Status::LimitReached) == (result.limit != LimitReason::None));
  if (result.status == Status::Solved) RC_ASSERT(result.cost == best.value());
  if (result.status == Status::Unsolvable) RC_ASSERT(!best.has_value());
  RC_ASSERT(result.statistics.generated <= states + 1);
}

RC_GTEST_PROP(AStar, IsDeterministic, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const Result first = astar(*samples::packed(task), goal, {});
  const Result second = astar(*samples::packed(task), goal, {});
  RC_ASSERT(first.plan == second.plan);
  RC_ASSERT(first.statistics.expanded == second.statistics.expanded);
}

TEST(AStar, StopsAfterTheGivenStates) {
  const Task task = samples::switches(12);
  const Result result =
      astar(*samples::packed(task), samples::allOnAndOneOff(12), Limits{}.withStates(100));
  EXPECT_EQ(result.status, Status::LimitReached);
  EXPECT_EQ(result.limit, LimitReason::States);
  EXPECT_EQ(result.statistics.generated, 101U);
}

TEST(AStar, StopsAboveTheGivenBytes) {
  const Task task = samples::switches(16);
  Limits limits;
  limits.bytes = 500'000;
  const Result result = astar(*samples::packed(task), samples::allOnAndOneOff(16), limits);
  EXPECT_EQ(result.status, Status::LimitReached);
  EXPECT_EQ(result.limit, LimitReason::Memory);
}

TEST(AStar, StopsAtTheFirstStateOnceCancelled) {
  const Task task = samples::switches(12);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  const Result result = astar(*samples::packed(task), samples::allOnAndOneOff(12), limits);
  EXPECT_EQ(result.status, Status::LimitReached);
  EXPECT_EQ(result.limit, LimitReason::Cancelled);
  EXPECT_EQ(result.statistics.generated, 1U);
}

TEST(AStar, StopsAtAPastDeadline) {
  const Task task = samples::switches(12);
  const Result result =
      astar(*samples::packed(task), samples::allOnAndOneOff(12), Limits{}.withSeconds(-1));
  EXPECT_EQ(result.status, Status::LimitReached);
  EXPECT_EQ(result.limit, LimitReason::Time);
  EXPECT_LE(result.statistics.generated, 16U);
}

TEST(AStar, ProvesWhatNothingReaches) {
  const Result result =
      astar(*samples::packed(samples::switches(6)), samples::allOnAndOneOff(6), {});
  EXPECT_EQ(result.status, Status::Unsolvable);
  EXPECT_EQ(result.statistics.expanded, 64U);
}

TEST(AStar, LooksAtWhatTheGoalNeedsAlone) {
  const Result result = astar(*samples::packed(samples::switches(12)), samples::impossible(), {});
  EXPECT_EQ(result.status, Status::Unsolvable);
  EXPECT_EQ(result.statistics.expanded, 2U) << "eleven switches don't matter";
}

TEST(AStar, AGoalThatHoldsNeedsNoPlan) {
  const Result result = astar(*samples::packed(samples::switches(3)), task::FactSet{0, 2}, {});
  EXPECT_EQ(result.status, Status::Solved);
  EXPECT_TRUE(result.plan.empty());
  EXPECT_EQ(result.cost, 0);
}

}  // namespace
}  // namespace goal_alignment::search
