// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/achievability.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/lifted_space.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

namespace goal_alignment::achievability {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::make;
using samples::setOf;

std::vector<Literal> goalOf(const Hagl& hagl, CandidateBits set) {
  std::vector<Literal> goal = hagl.specified;
  const std::vector<Literal> more = hagl.fluents(set);
  goal.insert(goal.end(), more.begin(), more.end());
  return goal;
}

RC_GTEST_PROP(Achievability, CheckEqualsBruteForceForEverySubset, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random, 7);
  RC_LOG() << samples::text(hagl);
  for (const SearchBudget& budget : samples::stageBudgets()) {
    const auto robot = make(hagl, budget);
    // From a random one on: what is remembered must not depend on the order of the questions.
    const CandidateBits offset = random.below(hagl.all() + 1);
    for (CandidateBits i = 0; i <= hagl.all(); ++i) {
      const CandidateBits set = (i + offset) & hagl.all();
      const Check check = robot->check(setOf(hagl.size(), set), {});
      if (budget.second_greedy == 1 && check.verdict == Verdict::Unknown) continue;
      RC_ASSERT(check.verdict ==
                (hagl.achievable(set) ? Verdict::Achievable : Verdict::Unachievable));
      if (check.verdict != Verdict::Achievable) continue;
      const auto plan = task::names(robot->task(), check.plan);
      RC_ASSERT(!validation::fault(hagl.robot, plan, goalOf(hagl, set)).has_value());
    }
  }
}

RC_GTEST_PROP(Achievability, ReachableAloneEqualsBruteForce, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const auto robot = make(hagl);
  // With and without what checks have taught.
  if (oracles::chance(random, 0.5)) robot->findAllConflicts({});
  const std::vector<Verdict> verdicts = robot->reachableAlone({});
  RC_ASSERT(verdicts.size() == hagl.size());
  for (std::size_t f = 0; f < hagl.size(); ++f) {
    RC_ASSERT(verdicts[f] ==
              (hagl.achievableAlone(f) ? Verdict::Achievable : Verdict::Unachievable));
  }
}

RC_GTEST_PROP(Achievability, AlwaysTrueIsTrueInEveryReachableState, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const auto robot = make(hagl);
  for (const oracles::Atoms& atoms : oracles::LiftedSpace(hagl.robot, 10'000).states()) {
    for (const std::size_t f : members(robot->alwaysTrue())) {
      RC_ASSERT(oracles::holds({hagl.candidates[f]}, atoms));
    }
  }
}

RC_GTEST_PROP(Achievability, OptimalPlansCostTheLeast, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const auto robot = make(hagl);
  const oracles::LiftedSpace space(hagl.robot, 10'000);
  for (int i = 0; i < 5; ++i) {
    const CandidateBits set = random.below(hagl.all() + 1);
    if (!hagl.achievable(set)) continue;
    const search::Result best = robot->optimalPlan(setOf(hagl.size(), set), {});
    RC_ASSERT(best.status == search::Status::Solved);
    RC_ASSERT(best.cost == space.cheapest(goalOf(hagl, set)).value());
  }
}

// Everything found from names, relaxed reachability and mutexes alone, before any search.
RC_GTEST_PROP(Achievability, ConflictsOfTheFirstStagesAreSound, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const auto robot = make(hagl);
  RC_ASSERT(robot->plannerCalls() == 0U);
  for (const Conflict& conflict : robot->conflicts()) {
    RC_ASSERT(conflict.proven);
    RC_ASSERT(!hagl.achievable(conflict.members.to_ulong()));
    RC_ASSERT(conflict.members.count() <= 2U);
  }
}

RC_GTEST_PROP(Achievability, RecordedExecutionsAreAchievedSets, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const validation::Execution execution = validation::execute(hagl.robot, hagl.input.human_plan);
  const std::size_t runs = execution.stepsRun();
  const auto robot = make(hagl);
  robot->recordExecution({hagl.input.human_plan.begin(),
                          hagl.input.human_plan.begin() + static_cast<std::ptrdiff_t>(runs)});
  for (const auto& [set, plan] : robot->achieved()) {
    const auto steps = task::names(robot->task(), plan);
    RC_ASSERT(!validation::fault(hagl.robot, steps, goalOf(hagl, set.to_ulong())).has_value());
  }
  // A state on the way that satisfies G^H answers for itself, without a search.
  execution.forEachState([&](std::size_t, const validation::AtomSet& state) {
    if (!validation::unsatisfied(hagl.robot, state, hagl.specified).empty()) return;
    CandidateBits set = 0;
    for (std::size_t f = 0; f < hagl.size(); ++f) {
      const bool holds = validation::unsatisfied(hagl.robot, state, {hagl.candidates[f]}).empty();
      if (holds) set |= CandidateBits{1} << f;
    }
    RC_ASSERT(robot->check(setOf(hagl.size(), set), {}).verdict == Verdict::Achievable);
  });
  RC_ASSERT(robot->plannerCalls() == 0U);
}

RC_GTEST_PROP(Achievability, ACancelProvesNothing, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  CancelToken token;
  Limits limits;
  limits.cancel = &token;
  const auto robot = make(hagl);
  token.cancel();
  for (CandidateBits set = 0; set <= hagl.all(); ++set) {
    const Check check = robot->check(setOf(hagl.size(), set), limits);
    if (check.verdict == Verdict::Unknown) {
      RC_ASSERT(check.limit == LimitReason::Cancelled);
      RC_ASSERT(robot->lastLimit() == LimitReason::Cancelled);
    }
    if (check.verdict == Verdict::Achievable) RC_ASSERT(hagl.achievable(set));
    if (check.verdict == Verdict::Unachievable) RC_ASSERT(!hagl.achievable(set));
  }
}

RC_GTEST_PROP(Achievability, ALimitLeavesACandidateAloneUnknown, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  CancelToken token;
  Limits limits;
  limits.cancel = &token;
  const auto robot = make(hagl);
  token.cancel();
  const std::vector<Verdict> verdicts = robot->reachableAlone(limits);
  for (std::size_t f = 0; f < hagl.size(); ++f) {
    const Verdict verdict = verdicts[f];
    if (verdict == Verdict::Achievable) RC_ASSERT(hagl.achievableAlone(f));
    if (verdict == Verdict::Unachievable) RC_ASSERT(!hagl.achievableAlone(f));
    if (verdict == Verdict::Unknown) RC_ASSERT(robot->lastLimit() == LimitReason::Cancelled);
  }
}

TEST(Achievability, StopsBeforeItIsMadeWhenCancelled) {
  RandomSource random(3);
  const Hagl hagl = oracles::randomHagl(random);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(make(hagl, {}, limits), LimitReached);
}

}  // namespace
}  // namespace goal_alignment::achievability
