// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/lm_cut.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <vector>

#include "oracles/heuristics.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"

namespace goal_alignment::heuristics {
namespace {

using oracles::Facts;
using task::Cost;
using task::Task;

RC_GTEST_PROP(LmCut, LiesBetweenHMaxAndTheOptimalCost, ()) {
  RandomSource random = oracles::anySource();
  oracles::TaskSize size;
  size.conditional = false;  // with conditional effects LM-cut may fall below h_max
  const Task task = oracles::randomTask(random, size);
  const task::FactSet goal = oracles::randomGoal(random, task);
  LmCut lm_cut(task, goal);
  for (const auto& [facts, way] : oracles::reachable(task, oracles::initialFacts(task))) {
    const Cost h = lm_cut.evaluate(oracles::stateOf(task, facts).data());
    const std::optional<Cost> h_max = oracles::hMax(task, facts, goal);
    RC_ASSERT((h == kInfinity) == !h_max.has_value());
    if (!h_max) continue;
    RC_ASSERT(h >= *h_max);
    const std::optional<Cost> best = oracles::optimalCost(task, facts, goal);
    if (best) RC_ASSERT(h <= *best);
  }
}

/// Every plan contains an operator of each landmark, and no operator pays more than its cost.
bool areLandmarks(const Landmarks& landmarks, const Task& task, const Facts& state,
                  const task::Goal& goal) {
  std::vector<Cost> paid(task.operators.size(), 0);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    Task without = task;
    for (const task::OperatorId op : landmarks[i]) {
      paid[op] += landmarks[i].cost;
      without.operators[op].precondition = {static_cast<task::FactId>(task.facts.size())};
    }
    if (oracles::optimalCost(without, state, goal)) return false;
  }
  for (task::OperatorId op = 0; op < task.operators.size(); ++op) {
    if (paid[op] > task.operators[op].cost) return false;
  }
  return true;
}

RC_GTEST_PROP(LmCut, IsTheCostOfTrueLandmarks, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  LmCut lm_cut(task, goal);
  for (const auto& [facts, way] : oracles::reachable(task, oracles::initialFacts(task))) {
    const Cost h = lm_cut.evaluate(oracles::stateOf(task, facts).data());
    const std::optional<Cost> best = oracles::optimalCost(task, facts, goal);
    if (best) RC_ASSERT(h <= *best);
    if (h == kInfinity) continue;
    RC_ASSERT(h == lm_cut.landmarks().total());
    RC_ASSERT(areLandmarks(lm_cut.landmarks(), task, facts, goal));
  }
}

RC_GTEST_PROP(LmCut, InheritsTrueLandmarks, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  LmCut lm_cut(task, goal);
  Facts facts = oracles::initialFacts(task);
  Cost h = lm_cut.evaluate(oracles::stateOf(task, facts).data());
  for (int step = 0; step < 8 && h != kInfinity; ++step) {
    const auto applicable = oracles::applicableOperators(task, facts);
    if (applicable.empty()) break;
    const task::OperatorId op = applicable[random.below(applicable.size())];
    const Landmarks before = lm_cut.landmarks();
    facts = oracles::successor(task.operators[op], facts);
    h = lm_cut.evaluate(oracles::stateOf(task, facts).data(), before, op);
    RC_ASSERT((h == kInfinity) ==
              (LmCut(task, goal).evaluate(oracles::stateOf(task, facts).data()) == kInfinity));
    if (h == kInfinity) break;
    RC_ASSERT(h == lm_cut.landmarks().total());
    RC_ASSERT(areLandmarks(lm_cut.landmarks(), task, facts, goal));
  }
}

TEST(LmCut, CutShortByACancelIsALowerBoundStill) {
  RandomSource random(1);
  const Task task = oracles::randomTask(random);
  const task::FactSet goal = oracles::randomGoal(random, task);
  const auto initial = oracles::stateOf(task, oracles::initialFacts(task));
  CancelToken token;
  LmCut whole(task, goal);
  LmCut stopped(task, goal, &token);
  EXPECT_EQ(stopped.evaluate(initial.data()), whole.evaluate(initial.data()));
  token.cancel();
  const Cost h = stopped.evaluate(initial.data());
  EXPECT_TRUE(h == 0 || h == kInfinity) << "no cut was made";
  EXPECT_LE(h, whole.evaluate(initial.data()));
}

RC_GTEST_PROP(LmCut, IsZeroExactlyInGoalStatesWhereNothingIsFree, ()) {
  RandomSource random = oracles::anySource();
  oracles::TaskSize size;
  size.least_cost = 1;
  const Task task = oracles::randomTask(random, size);
  const task::FactSet goal = oracles::randomGoal(random, task);
  LmCut lm_cut(task, goal);
  for (const auto& [facts, way] : oracles::reachable(task, oracles::initialFacts(task))) {
    const Cost h = lm_cut.evaluate(oracles::stateOf(task, facts).data());
    RC_ASSERT((h == 0) == oracles::holds(goal, facts));
  }
}

// The evaluator keeps buffers between calls: what it says must not depend on what it was asked
// before.
RC_GTEST_PROP(LmCut, ForgetsEarlierEvaluations, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::FactSet goal = oracles::randomGoal(random, task);
  LmCut used(task, goal);
  for (const auto& [facts, way] : oracles::reachable(task, oracles::initialFacts(task))) {
    const task::State state = oracles::stateOf(task, facts);
    RC_ASSERT(used.evaluate(state.data()) == LmCut(task, goal).evaluate(state.data()));
  }
}

/// From 0 to 3 in two ways, costs as in the example of Helmert & Domshlak's talk: h_max sees the
/// dearer half only, LM-cut both.
TEST(LmCut, AddsUpLandmarksThatHMaxCannot) {
  Task task;
  task.facts.resize(3);
  task.operators.push_back({{"left", {}}, {0}, {1}, {}, 3});
  task.operators.push_back({{"right", {}}, {0}, {2}, {}, 4});
  task.initial = {0};
  const Facts initial = oracles::initialFacts(task);
  EXPECT_EQ(oracles::hMax(task, initial, {1, 2}), 4);
  EXPECT_EQ(LmCut(task, task::FactSet{1, 2}).evaluate(oracles::stateOf(task, initial).data()), 7);
}

TEST(LmCut, CostsBeyondTheBucketsOfItsQueueAreExact) {
  Task task;
  task.facts.resize(4);
  task.operators.push_back({{"a", {}}, {0}, {1}, {}, 1'000'000'000'000});
  task.operators.push_back({{"b", {}}, {1}, {2}, {}, 5});
  task.operators.push_back({{"c", {}}, {2}, {3}, {}, 70'000});
  task.initial = {0};
  const task::State state = task::initialState(task);
  EXPECT_EQ(LmCut(task, task::FactSet{3}).evaluate(state.data()), 1'000'000'070'005);
}

TEST(LmCut, AnEmptyGoalCostsNothing) {
  RandomSource random(1);
  const Task task = oracles::randomTask(random);
  EXPECT_EQ(LmCut(task, task::FactSet{}).evaluate(task::initialState(task).data()), 0);
}

}  // namespace
}  // namespace goal_alignment::heuristics
