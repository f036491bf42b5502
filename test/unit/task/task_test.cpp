// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/task/task.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "goal_alignment/task/state.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"

namespace goal_alignment::task {
namespace {

Task threeFacts() {
  Task task;
  task.facts.resize(70);
  task.operators.push_back({{"go", {"a", "b"}}, {0}, {69}, {0}, 2});
  task.operators.push_back({{"back", {"b"}}, {69}, {0}, {69}, 5});
  task.initial = {0, 64};
  return task;
}

TEST(Task, SumsCostsAndNamesSteps) {
  const Task task = threeFacts();
  EXPECT_EQ(cost(task, {0, 1, 0}), 9);
  EXPECT_EQ(cost(task, {}), 0);
  EXPECT_EQ(names(task, {1, 0}), (std::vector<GroundName>{{"back", {"b"}}, {"go", {"a", "b"}}}));
}

TEST(Task, MakesSortedSets) {
  EXPECT_EQ(makeFactSet({3, 1, 3, 2, 1}), (FactSet{1, 2, 3}));
  EXPECT_EQ(makeFactSet({}), FactSet{});
}

TEST(Task, UnitesSetsAndFindsFactsInThem) {
  EXPECT_EQ(unite({1, 3}, {0, 3, 4}), (FactSet{0, 1, 3, 4}));
  EXPECT_EQ(unite({}, {2}), FactSet{2});
  EXPECT_TRUE(has({1, 3}, 3));
  EXPECT_FALSE(has({1, 3}, 2));
}

TEST(State, HoldsFactsBeyondTheFirstWord) {
  const State state = initialState(threeFacts());
  EXPECT_EQ(state.size(), 2U);
  EXPECT_TRUE(contains(state.data(), {0, 64}));
  EXPECT_TRUE(contains(state.data(), {}));
  EXPECT_FALSE(contains(state.data(), {0, 65}));
}

TEST(State, WordsAreAsManyAsNeeded) {
  EXPECT_EQ(wordsFor(0), 0U);
  EXPECT_EQ(wordsFor(1), 1U);
  EXPECT_EQ(wordsFor(64), 1U);
  EXPECT_EQ(wordsFor(65), 2U);
}

TEST(State, ConditionsAreReadInTheStateBefore) {
  // Swaps two switches at once, and lets the add win over the delete of another effect.
  Task task;
  task.facts.resize(3);
  Operator op{{"swap", {}}, {}, {}, {2}, 1, {{{0}, {1}, {0}}, {{1}, {0}, {1}}, {{0}, {2}, {}}}};
  const State before = {0b101};
  State after(1);
  apply(op, before.data(), 1, after.data());
  EXPECT_EQ(after[0], 0b110U);
  const State both = {0b011};
  apply(op, both.data(), 1, after.data());
  EXPECT_EQ(after[0], 0b111U);
}

TEST(State, AGoalIsSatisfiedByAnyAlternative) {
  const State state = {0b011};
  EXPECT_TRUE(satisfies(state.data(), FactSet{0, 1}));
  EXPECT_TRUE(satisfies(state.data(), Goal(std::vector<FactSet>{{2}, {1}})));
  EXPECT_FALSE(satisfies(state.data(), Goal(std::vector<FactSet>{{2}, {0, 2}})));
  EXPECT_FALSE(satisfies(state.data(), Goal()));
}

TEST(State, ForEachBitVisitsInRisingOrder) {
  const State state = initialState(threeFacts());
  std::vector<std::size_t> bits;
  forEachBit(state.data(), state.size(), [&](std::size_t bit) { bits.push_back(bit); });
  EXPECT_EQ(bits, (std::vector<std::size_t>{0, 64}));
}

RC_GTEST_PROP(State, ApplyEqualsTheSetDefinition, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random, {60, 140, 5, 10});
  State state = initialState(task);
  oracles::Facts facts = oracles::initialFacts(task);
  for (const Operator& op : task.operators) {
    RC_ASSERT(contains(state.data(), op.precondition) == oracles::holds(op.precondition, facts));
    State after(state.size());
    apply(op, state.data(), state.size(), after.data());
    RC_ASSERT(oracles::factsOf(task, state.data()) == facts);
    facts = oracles::successor(op, facts);
    RC_ASSERT(oracles::factsOf(task, after.data()) == facts);
    state = after;
  }
}

}  // namespace
}  // namespace goal_alignment::task
