// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/alignment/beliefs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "oracles/algorithm_one.h"
#include "oracles/lifted_space.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

namespace goal_alignment::alignment {
namespace {

using oracles::Hagl;

constexpr std::uint64_t kPlenty = 1'000'000;

Problem problemOf(const Hagl& hagl) {
  return makeProblem(hagl.robot, hagl.human, hagl.input.goal, hagl.input.human_plan);
}

bool close(double a, double b) {
  return std::abs(a - b) < 1e-9;
}

RC_GTEST_PROP(CostDifferences, EqualBruteForceOneByOne, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const CostDifferences found = costDifferences(problemOf(hagl), {true, kPlenty}, {});
  RC_ASSERT(found.exact);
  RC_ASSERT(found.values == hagl.costDifferences());
  RC_ASSERT(found.planner_calls <= hagl.size() + 1);
  RC_ASSERT(costDifferences(problemOf(hagl), {true, kPlenty, false, 3}, {}).values == found.values);
}

/// With the side effects that the robot may have among the candidates.
Problem withSideEffects(Hagl& hagl) {
  Problem problem = problemOf(hagl);
  addNegativeCandidates(problem, {});
  hagl.candidates.clear();
  for (const Candidate& candidate : problem.candidates)
    hagl.candidates.push_back(candidate.fluent);
  return problem;
}

// The human's model is not the robot's: what the robot may do may be out of reach there, change
// there or have no name there.
RC_GTEST_PROP(CostDifferences, OfSideEffectsEqualBruteForceToo, ()) {
  RandomSource random = oracles::anySource();
  Hagl hagl = oracles::randomHagl(random);
  const Problem problem = withSideEffects(hagl);
  const CostDifferences found = costDifferences(problem, {true, kPlenty}, {});
  RC_ASSERT(found.exact);
  RC_ASSERT(found.values == hagl.costDifferences());
  const CostDifferences bounds = costDifferences(problem, {true, random.below(10)}, {});
  for (std::size_t f = 0; f < hagl.size(); ++f)
    RC_ASSERT(bounds.values[f] >= 0 && bounds.values[f] <= found.values[f]);
}

RC_GTEST_PROP(CostDifferences, CountTheModelsCostsWhereWanted, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_PRE(hagl.human.has_costs);
  const Problem problem = problemOf(hagl);
  const oracles::LiftedSpace space(hagl.human, 10'000, false);
  const CostDifferences found = costDifferences(problem, {false, kPlenty}, {});
  for (std::size_t f = 0; f < hagl.size(); ++f) {
    std::vector<Literal> goal = hagl.specified;
    goal.push_back(hagl.candidates[f]);
    const std::int64_t best = space.cheapest(goal).value();
    RC_ASSERT(found.values[f] == static_cast<double>(problem.expectation.cost() - best));
  }
}

// Where a search is cut short the cheapest prefix of π^H stands in: never below the optimal cost,
// so the difference is never above the true one.
RC_GTEST_PROP(CostDifferences, ALimitLeavesABoundFromAbove, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const std::vector<double> exact = hagl.costDifferences();
  const CostDifferences found = costDifferences(problemOf(hagl), {true, random.below(10)}, {});
  for (std::size_t f = 0; f < hagl.size(); ++f) {
    RC_ASSERT(found.values[f] >= 0);
    RC_ASSERT(found.values[f] <= exact[f]);
  }
  if (found.exact) RC_ASSERT(found.values == exact);
}

TEST(CostDifferences, OfTheDeskAreWorkedOutByHand) {
  const Problem problem =
      makeProblem(samples::deskRobot(), samples::deskHuman(), {}, samples::deskPlan());
  // (down a) (down c) (free) (held a) (held b) (red a); the plan costs 2.
  EXPECT_EQ(costDifferences(problem, {true, kPlenty}, {}).values,
            (std::vector<double>{2, 2, 2, 1, 1, 2}));
}

const char* const kLamps = R"((define (domain lamps)
  (:predicates (lit) (read) (curtain-open) (neighbour-awake))
  (:action switch-on :parameters () :effect (and (lit) (neighbour-awake)))
  (:action open-curtain :parameters () :effect (curtain-open))
  (:action draw-light :parameters () :precondition (curtain-open) :effect (lit))
  (:action study :parameters () :precondition (lit) :effect (read))))";

// Opening the curtain costs the person a step, and spares the neighbour: both explain the plan.
TEST(CostDifferences, ASideEffectThatWasAvoidedExplainsThePlan) {
  const auto lamps = [] {
    return pddl::readModel(
        {"d.pddl", kLamps},
        {"p.pddl", "(define (problem dark) (:domain lamps) (:init) (:goal (read)))"});
  };
  Problem problem =
      makeProblem(lamps(), lamps(), {}, {{"open-curtain", {}}, {"draw-light", {}}, {"study", {}}});
  addNegativeCandidates(problem, {});
  ASSERT_EQ(literals(problem).size(), 4U);
  // (curtain-open) (lit) (not (neighbour-awake))
  std::vector<Literal> fluents;
  for (const Candidate& candidate : problem.candidates)
    fluents.push_back(candidate.fluent);
  const std::vector<double> values = costDifferences(problem, {true, kPlenty}, {}).values;
  for (std::size_t f = 0; f < fluents.size(); ++f)
    EXPECT_EQ(values[f], fluents[f].text() == "(lit)" ? 1 : 0) << fluents[f].text();
}

// When the time for searches is up, the bounds are used and nothing is thrown.
RC_GTEST_PROP(CostDifferences, WithoutTimeForSearchesTheBoundsDo, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  CostOptions no_time{true, kPlenty};
  no_time.search_seconds = 0;
  const CostDifferences found = costDifferences(problemOf(hagl), no_time, {});
  const std::vector<double> exact = hagl.costDifferences();
  for (std::size_t f = 0; f < hagl.size(); ++f)
    RC_ASSERT(found.values[f] <= exact[f]);
}

TEST(CostDifferences, StopWhenCancelled) {
  const Problem problem =
      makeProblem(samples::deskRobot(), samples::deskHuman(), {}, samples::deskPlan());
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(costDifferences(problem, {true, kPlenty}, limits), LimitReached);
}

Problem withCandidates(const std::vector<bool>& is_static) {
  Problem problem;
  for (const bool fixed : is_static)
    problem.candidates.push_back({{}, fixed});
  return problem;
}

TEST(Beliefs, NormalisedShareTheExpectationAmongWhatCanChange) {
  const Problem problem = withCandidates({false, false, true});
  const std::vector<double> found = beliefs(problem, {0, 1, 0}, {BeliefMode::Normalised, 1, 0.5});
  const double sum = 1 + std::exp(-1);
  EXPECT_NEAR(found[0], 0.5 / sum, 1e-12);
  EXPECT_NEAR(found[1], 0.5 * std::exp(-1) / sum, 1e-12);
  EXPECT_NEAR(found[2], 0.5 / sum, 1e-12);  // its own weight, though it is not counted
}

TEST(Beliefs, RawAreTheFormulasOwnClamped) {
  const Problem problem = withCandidates({false, false, false});
  const std::vector<double> found = beliefs(problem, {0, 1, 100}, {BeliefMode::Raw, 2});
  EXPECT_DOUBLE_EQ(found[0], 0.98);
  EXPECT_DOUBLE_EQ(found[1], std::exp(-2));
  EXPECT_DOUBLE_EQ(found[2], 0.02);
}

TEST(Beliefs, FlatAreAllTheSame) {
  const Problem problem = withCandidates({false, true});
  EXPECT_EQ(beliefs(problem, {0, 7}, {BeliefMode::Flat, 1, 1, 0.3}),
            (std::vector<double>{0.3, 0.3}));
  EXPECT_EQ(beliefs(problem, {0, 7}, {BeliefMode::Flat, 1, 1, 1}),
            (std::vector<double>{0.98, 0.98}));
}

// The static one is far likelier: beside its weight the others' would vanish, and 0/0 is no belief.
TEST(Beliefs, StaticCandidatesDoNotDrownTheOthers) {
  const Problem problem = withCandidates({true, false, false});
  const std::vector<double> found = beliefs(problem, {0, 740, 2000}, {});
  EXPECT_DOUBLE_EQ(found[0], 0.98);
  EXPECT_DOUBLE_EQ(found[1], 0.98);
  EXPECT_DOUBLE_EQ(found[2], 0.02);
}

TEST(Beliefs, OnlyStaticCandidatesShareNothing) {
  const Problem problem = withCandidates({true, true});
  EXPECT_EQ(beliefs(problem, {0, 1}, {}), (std::vector<double>{0.02, 0.02}));
  EXPECT_TRUE(beliefs(withCandidates({}), {}, {}).empty());
}

RC_GTEST_PROP(Beliefs, LieWithinTheClampAndFallWithTheDifference, ()) {
  RandomSource random = oracles::anySource();
  std::vector<bool> is_static;
  std::vector<double> differences;
  for (std::size_t n = oracles::between(random, 1, 12); n > 0; --n) {
    is_static.push_back(oracles::chance(random, 0.3));
    differences.push_back(static_cast<double>(random.below(2000)));
  }
  for (const BeliefMode mode : {BeliefMode::Normalised, BeliefMode::Raw, BeliefMode::Flat}) {
    const BeliefOptions options = {mode, random.unit() * 3, 0.1 + random.unit() * 4, random.unit()};
    const std::vector<double> found = beliefs(withCandidates(is_static), differences, options);
    RC_ASSERT(found.size() == differences.size());
    for (std::size_t f = 0; f < found.size(); ++f) {
      RC_ASSERT(found[f] >= 0.02 && found[f] <= 0.98);
      for (std::size_t g = 0; g < found.size(); ++g) {
        if (differences[f] < differences[g]) RC_ASSERT(found[f] >= found[g]);
      }
    }
  }
}

RC_GTEST_PROP(Beliefs, NormalisedSumUpToKappaWhereNothingIsClamped, ()) {
  RandomSource random = oracles::anySource();
  std::vector<bool> is_static;
  std::vector<double> differences;
  for (std::size_t n = oracles::between(random, 2, 8); n > 0; --n) {
    is_static.push_back(oracles::chance(random, 0.3));
    differences.push_back(static_cast<double>(random.below(4)));
  }
  const std::vector<double> found =
      beliefs(withCandidates(is_static), differences, {BeliefMode::Normalised, 0.5, 0.9});
  double sum = 0;
  bool clamped = false;
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (!is_static[f]) sum += found[f];
    clamped = clamped || found[f] <= 0.02 || found[f] >= 0.98;
  }
  const bool all_static = std::all_of(is_static.begin(), is_static.end(), [](bool b) { return b; });
  if (!clamped && !all_static) RC_ASSERT(close(sum, 0.9));
}

RC_GTEST_PROP(PaperBeliefs, SumToOneAndEqualTheFormula, ()) {
  RandomSource random = oracles::anySource();
  std::vector<double> differences;
  for (std::size_t n = oracles::between(random, 1, 20); n > 0; --n) {
    differences.push_back(static_cast<double>(random.below(30)));
  }
  const double beta = random.unit() * 3;
  const std::vector<double> found = paperBeliefs(differences, beta);
  const std::vector<double> expected = oracles::normalisedBeliefs(differences, beta);
  RC_ASSERT(close(std::accumulate(found.begin(), found.end(), 0.0), 1));
  for (std::size_t f = 0; f < found.size(); ++f)
    RC_ASSERT(close(found[f], expected[f]));
}

// exp(−β·Δ) is zero in double for all of them; their ratio is not.
TEST(PaperBeliefs, LargeDifferencesDoNotVanishTogether) {
  const std::vector<double> found = paperBeliefs({5000, 5001}, 1);
  EXPECT_NEAR(found[0] / found[1], std::exp(1), 1e-9);
  EXPECT_NEAR(found[0] + found[1], 1, 1e-12);
  EXPECT_TRUE(paperBeliefs({}, 1).empty());
}

}  // namespace
}  // namespace goal_alignment::alignment
