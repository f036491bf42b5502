// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/symbolic.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <thread>

#include "counting.h"
#include "oracles/conditional_task.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "samples.h"

namespace goal_alignment::search {
namespace {

using heuristics::groupsFromInvariants;
using heuristics::groupsFromPairs;
using heuristics::MutexGroups;
using heuristics::MutexTable;
using oracles::Facts;
using task::FactId;
using task::FactSet;
using task::Task;

bool someHold(const std::set<Facts>& states, const FactSet& facts) {
  return std::any_of(states.begin(), states.end(),
                     [&](const Facts& state) { return oracles::holds(facts, state); });
}

/// Where the plan leads; the end of the world where a step can't be taken.
Facts afterPlan(const Task& task, const task::Plan& plan) {
  task::State state = task::initialState(task);
  for (const task::OperatorId id : plan) {
    const task::State before = state;
    if (!task::contains(before.data(), task.operators[id].precondition)) return {};
    task::apply(task.operators[id], before.data(), before.size(), state.data());
  }
  return oracles::factsOf(task, state.data());
}

/// As many states as by brute force, and the same sets of up to three facts in one of them.
void checkReached(const Task& task, const MutexGroups& groups) {
  Symbolic symbolic(task, groups);
  RC_ASSERT(symbolic.run({}) == LimitReason::None);
  RC_ASSERT(symbolic.complete());
  const std::set<Facts> states = oracles::conditionallyReachable(task);
  const auto runs = [&](const FactSet& goal) {
    const auto plan = symbolic.plan(goal, {});
    return plan && oracles::holds(goal, afterPlan(task, *plan));
  };
  RC_ASSERT(symbolic.stateCount() == static_cast<double>(states.size()));
  for (FactId f = 0; f < task.facts.size(); ++f) {
    for (FactId g = f; g < task.facts.size(); ++g) {
      for (FactId h = g; h < task.facts.size(); ++h) {
        const FactSet facts = task::makeFactSet({f, g, h});
        RC_ASSERT(symbolic.reachable(facts) == someHold(states, facts));
        RC_ASSERT(runs(facts) == someHold(states, facts));
      }
    }
  }
}

RC_GTEST_PROP(Symbolic, ReachesWhatBruteForceReaches, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  checkReached(task, groupsFromPairs(task, MutexTable(task, {}), {}));
  checkReached(task, groupsFromInvariants(task, {}));
}

RC_GTEST_PROP(Symbolic, ReachesTheSameThroughConditionalEffects, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomConditionalTask(random);
  checkReached(task, groupsFromInvariants(task, {}));
}

TEST(Symbolic, ADisjunctionIsReachableWhereAnAlternativeIs) {
  const Task task = samples::switches(3);
  const MutexGroups groups = groupsFromInvariants(task, {});
  Symbolic symbolic(task, groups);
  ASSERT_EQ(symbolic.run({}), LimitReason::None);
  EXPECT_TRUE(symbolic.reachable(task::Goal(std::vector<FactSet>{{0, 1}, {1, 3}})));
  EXPECT_FALSE(symbolic.reachable(task::Goal(std::vector<FactSet>{{0, 1}, {2, 3}})));
  EXPECT_FALSE(symbolic.reachable(task::Goal()));
  EXPECT_TRUE(symbolic.reachable(FactSet{}));
}

// 2^200 states: no list of them ends.
TEST(Symbolic, CountsFarBeyondWhatCanBeListed) {
  const Task task = samples::switches(200);
  const MutexGroups groups = groupsFromInvariants(task, {});
  Symbolic symbolic(task, groups);
  ASSERT_EQ(symbolic.run({}), LimitReason::None);
  EXPECT_EQ(symbolic.stateCount(), std::ldexp(1.0, 200));
  EXPECT_EQ(symbolic.nodeCount(), 200U);
}

TEST(Symbolic, ProvesThatPigeonsDontFit) {
  const samples::Pigeonholes pigeonholes(7, 6);
  const MutexGroups groups =
      groupsFromPairs(pigeonholes.task, MutexTable(pigeonholes.task, {}), {});
  Symbolic symbolic(pigeonholes.task, groups);
  ASSERT_EQ(symbolic.run({}), LimitReason::None);
  FactSet housed = pigeonholes.housed;
  EXPECT_FALSE(symbolic.reachable(housed));
  housed.pop_back();
  EXPECT_TRUE(symbolic.reachable(housed));
}

/// By brute force over all subsets of the candidates, smaller ones first.
std::set<FactSet> conflictsByDefinition(const std::set<Facts>& states, const task::Goal& goal,
                                        const FactSet& candidates) {
  std::set<FactSet> conflicts;
  std::vector<std::size_t> subsets(std::size_t{1} << candidates.size());
  std::iota(subsets.begin(), subsets.end(), 0);
  std::stable_sort(subsets.begin(), subsets.end(), [](std::size_t a, std::size_t b) {
    return __builtin_popcountll(a) < __builtin_popcountll(b);
  });
  for (const std::size_t subset : subsets) {
    FactSet facts;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if ((subset >> i & 1U) != 0) facts.push_back(candidates[i]);
    }
    const auto had = [&](const Facts& state) {
      const auto met = [&](const FactSet& alternative) {
        return oracles::holds(alternative, state);
      };
      return oracles::holds(facts, state) &&
             std::any_of(goal.alternatives.begin(), goal.alternatives.end(), met);
    };
    const auto within = [&](const FactSet& known) {
      return std::includes(facts.begin(), facts.end(), known.begin(), known.end());
    };
    if (std::none_of(states.begin(), states.end(), had) &&
        std::none_of(conflicts.begin(), conflicts.end(), within)) {
      conflicts.insert(facts);
    }
  }
  return conflicts;
}

void checkConflicts(RandomSource& random, const Task& task, const MutexGroups& groups) {
  Symbolic symbolic(task, groups);
  RC_ASSERT(symbolic.run({}) == LimitReason::None);
  const std::set<Facts> states = oracles::conditionallyReachable(task);
  task::Goal goal;
  for (std::size_t n = oracles::between(random, 0, 2); n > 0; --n)
    goal.alternatives.push_back(oracles::randomGoal(random, task));
  if (oracles::chance(random, 0.3)) goal = FactSet{};
  FactSet candidates;
  for (FactId fact = 0; fact < task.facts.size(); ++fact) {
    if (oracles::chance(random, 0.8)) candidates.push_back(fact);
  }
  const std::set<FactSet> expected = conflictsByDefinition(states, goal, candidates);
  const MinimalConflicts found = symbolic.minimalConflicts(goal, candidates, 100'000, {});
  RC_ASSERT(found.all);
  RC_ASSERT(found.sets.size() == expected.size());
  RC_ASSERT((std::set<FactSet>(found.sets.begin(), found.sets.end())) == expected);
  if (expected.empty()) return;
  const MinimalConflicts fewer =
      symbolic.minimalConflicts(goal, candidates, expected.size() - 1, {});
  RC_ASSERT(!fewer.all);
  RC_ASSERT(fewer.sets.size() == expected.size() - 1);
  for (const FactSet& conflict : fewer.sets)
    RC_ASSERT(expected.count(conflict) == 1);
}

RC_GTEST_PROP(Symbolic, FindsTheMinimalConflictsOfTheDefinition, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  checkConflicts(random, task, groupsFromPairs(task, MutexTable(task, {}), {}));
}

RC_GTEST_PROP(Symbolic, FindsThemDespiteConditionalEffects, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomConditionalTask(random);
  checkConflicts(random, task, groupsFromInvariants(task, {}));
}

// A counter of 14 bits: the only way to its end takes every step, 2^14 - 1 of them.
TEST(Symbolic, FindsALongWay) {
  Task task;
  constexpr FactId kBits = 14;
  task.facts.resize(2 * kBits);  // 2i: bit i is 0; 2i + 1: it is 1
  for (FactId bit = 0; bit < kBits; ++bit) {
    task.initial.push_back(2 * bit);
    task::Operator count = {{"count", {}}, {2 * bit}, {2 * bit + 1}, {2 * bit}, 1};
    for (FactId lower = 0; lower < bit; ++lower) {
      count.precondition.push_back(2 * lower + 1);
      count.add.push_back(2 * lower);
      count.del.push_back(2 * lower + 1);
    }
    for (FactSet* facts : {&count.precondition, &count.add, &count.del})
      *facts = task::makeFactSet(*facts);
    task.operators.push_back(count);
  }
  FactSet all_ones;
  for (FactId bit = 0; bit < kBits; ++bit)
    all_ones.push_back(2 * bit + 1);
  const MutexGroups groups = groupsFromInvariants(task, {});
  Symbolic symbolic(task, groups);
  ASSERT_EQ(symbolic.run({}), LimitReason::None);
  const auto plan = symbolic.plan(all_ones, {});
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->size(), (std::size_t{1} << kBits) - 1);
  EXPECT_TRUE(oracles::holds(all_ones, afterPlan(task, *plan)));
  EXPECT_FALSE(symbolic.plan(FactSet{0, 1}, {}));
  EXPECT_FALSE(symbolic.plan(all_ones, Limits{}.withStates(10)));
}

// Seven pigeons, five holes: every six of them are a conflict.
TEST(Symbolic, CountsConflictsOut) {
  const samples::Pigeonholes pigeonholes(7, 5);
  const MutexGroups groups = groupsFromInvariants(pigeonholes.task, {});
  Symbolic symbolic(pigeonholes.task, groups);
  ASSERT_EQ(symbolic.run({}), LimitReason::None);
  const MinimalConflicts found = symbolic.minimalConflicts(FactSet{}, pigeonholes.housed, 100, {});
  EXPECT_TRUE(found.all);
  EXPECT_EQ(found.sets.size(), 7U);
  for (const FactSet& conflict : found.sets)
    EXPECT_EQ(conflict.size(), 6U);
  const MinimalConflicts none =
      symbolic.minimalConflicts(FactSet{}, pigeonholes.housed, 100, Limits{}.withStates(3));
  EXPECT_FALSE(none.all);
  EXPECT_EQ(none.limit, LimitReason::States);
}

TEST(Symbolic, SaysWhichLimitEndedIt) {
  const Task task = samples::Pigeonholes(9, 8).task;
  const MutexGroups groups = groupsFromInvariants(task, {});
  Symbolic symbolic(task, groups);
  EXPECT_EQ(symbolic.run(Limits{}.withStates(500)), LimitReason::States);
  EXPECT_EQ(symbolic.run(Limits{}.withSeconds(-1)), LimitReason::Time);
  Limits narrow;
  narrow.bytes = 500'000;
  EXPECT_EQ(symbolic.run(narrow), LimitReason::Memory);
  CancelToken token;
  token.cancel();
  Limits cancelled;
  cancelled.cancel = &token;
  EXPECT_EQ(symbolic.run(cancelled), LimitReason::Cancelled);
  EXPECT_FALSE(symbolic.complete());
  // What a limit broke off may be tried again.
  EXPECT_EQ(symbolic.run({}), LimitReason::None);
  EXPECT_TRUE(symbolic.complete());
}

// Little memory makes it collect amid its work: it ends, or finds the same.
TEST(Symbolic, FindsTheSameWithLessMemory) {
  const Task task = samples::Pigeonholes(8, 7).task;
  const MutexGroups groups = groupsFromInvariants(task, {});
  Symbolic symbolic(task, groups);
  ASSERT_EQ(symbolic.run({}), LimitReason::None);
  int complete = 0;
  int out_of_memory = 0;
  for (Limits limits; complete < 3; limits.bytes += 100'000) {
    if (out_of_memory == 0) limits.bytes = 100'000;
    Symbolic again(task, groups);
    const LimitReason reason = again.run(limits);
    EXPECT_LE(again.bytes(), limits.bytes);
    ++(reason == LimitReason::None ? complete : out_of_memory);
    if (reason != LimitReason::None) {
      EXPECT_EQ(reason, LimitReason::Memory);
      continue;
    }
    EXPECT_EQ(again.stateCount(), symbolic.stateCount());
    EXPECT_EQ(again.nodeCount(), symbolic.nodeCount());
  }
  EXPECT_GT(out_of_memory, 0);
}

TEST(Symbolic, TheSameStepsEndItAtTheSamePlace) {
  const Task task = samples::Pigeonholes(6, 5).task;
  const MutexGroups groups = groupsFromInvariants(task, {});
  const auto enough = [&](std::uint64_t steps) {
    return Symbolic(task, groups).run(Limits{}.withStates(steps)) == LimitReason::None;
  };
  std::uint64_t most = 1;
  while (!enough(most))
    most *= 2;
  std::uint64_t least = most / 2;
  for (; most - least > 1;)
    (enough((least + most) / 2) ? most : least) = (least + most) / 2;
  for (int again = 0; again < 3; ++again) {
    EXPECT_FALSE(enough(least));
    EXPECT_TRUE(enough(most));
  }
}

TEST(Symbolic, TwoInTwoThreadsKnowNothingOfEachOther) {
  const Task task = samples::Pigeonholes(7, 6).task;
  const MutexGroups groups = groupsFromInvariants(task, {});
  Symbolic one(task, groups);
  Symbolic other(task, groups);
  std::thread thread([&] { other.run({}); });
  one.run({});
  thread.join();
  ASSERT_TRUE(one.complete() && other.complete());
  EXPECT_EQ(one.stateCount(), other.stateCount());
  EXPECT_EQ(one.nodeCount(), other.nodeCount());
}

}  // namespace
}  // namespace goal_alignment::search
