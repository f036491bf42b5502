// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/greedy.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"
#include "samples.h"

namespace goal_alignment::search {
namespace {

using task::Task;

Result solve(const Task& task, const task::FactSet& goal, const Limits& limits = {}) {
  return greedy(*samples::packed(task), goal, limits);
}

RC_GTEST_PROP(Greedy, SolvesExactlyWhatIsSolvable, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::FactSet goal = oracles::randomGoal(random, task);
  const auto best = oracles::optimalCost(task, oracles::initialFacts(task), goal);
  const Result result = solve(task, goal);
  RC_ASSERT(result.status == (best ? Status::Solved : Status::Unsolvable));
  if (!best) return;
  RC_ASSERT(samples::valid(task, goal, result));
  RC_ASSERT(result.cost >= *best);
}

RC_GTEST_PROP(Greedy, NeverMistakesALimitForAProof, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::FactSet goal = oracles::randomGoal(random, task);
  const auto best = oracles::optimalCost(task, oracles::initialFacts(task), goal);
  const std::uint64_t states = random.below(30);
  const Result result = solve(task, goal, Limits{}.withStates(states));
  RC_ASSERT((result.status == Status::LimitReached) == (result.limit != LimitReason::None));
  if (result.status == Status::Solved) RC_ASSERT(samples::valid(task, goal, result));
  if (result.status == Status::Unsolvable) RC_ASSERT(!best.has_value());
  RC_ASSERT(result.statistics.generated <= states + 1);
}

TEST(Greedy, StopsAfterTheGivenStates) {
  const Task task = samples::switches(12);
  const Result result = solve(task, samples::impossible(), Limits{}.withStates(100));
  EXPECT_EQ(result.status, Status::LimitReached);
  EXPECT_EQ(result.limit, LimitReason::States);
  EXPECT_EQ(result.statistics.generated, 101U);
}

TEST(Greedy, StopsAboveTheGivenBytes) {
  const Task task = samples::switches(16);
  Limits limits;
  limits.bytes = 500'000;
  const Result result = solve(task, samples::impossible(), limits);
  EXPECT_EQ(result.status, Status::LimitReached);
  EXPECT_EQ(result.limit, LimitReason::Memory);
}

TEST(Greedy, StopsAtTheFirstStateOnceCancelled) {
  const Task task = samples::switches(12);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  const Result result = solve(task, samples::impossible(), limits);
  EXPECT_EQ(result.status, Status::LimitReached);
  EXPECT_EQ(result.limit, LimitReason::Cancelled);
  EXPECT_EQ(result.statistics.generated, 1U);
}

TEST(Greedy, StopsAtAPastDeadline) {
  const Task task = samples::switches(12);
  const Result result = solve(task, samples::impossible(), Limits{}.withSeconds(-1));
  EXPECT_EQ(result.status, Status::LimitReached);
  EXPECT_EQ(result.limit, LimitReason::Time);
}

TEST(Greedy, ProvesWhatNothingReaches) {
  const Result result = solve(samples::switches(6), samples::impossible());
  EXPECT_EQ(result.status, Status::Unsolvable);
  EXPECT_EQ(result.statistics.expanded, 64U);
}

// Preferred operators lead straight there: a plan of 12 steps among 4096 states.
TEST(Greedy, GoesStraightToAnEasyGoal) {
  const Task task = samples::switches(12);
  task::FactSet goal;
  for (task::FactId on = 1; on < 24; on += 2)
    goal.push_back(on);
  const Result result = solve(task, goal);
  EXPECT_EQ(result.status, Status::Solved);
  EXPECT_EQ(result.cost, 12);
  EXPECT_LT(result.statistics.expanded, 50U);
}

}  // namespace
}  // namespace goal_alignment::search
