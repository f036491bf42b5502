// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/relaxed_task.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "oracles/heuristics.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"

namespace goal_alignment::heuristics {
namespace {

std::vector<std::uint32_t> list(const Rows& rows, std::size_t i) {
  return {rows[i].begin(), rows[i].end()};
}

RC_GTEST_PROP(RelaxedTask, RowsAreEachOthersTransposes, ()) {
  RandomSource random = oracles::anySource();
  const task::Task task = oracles::randomTask(random);
  const RelaxedTask relaxed(task, oracles::randomGoal(random, task));
  std::set<std::pair<std::uint32_t, std::uint32_t>> by_operator;
  std::set<std::pair<std::uint32_t, std::uint32_t>> by_fact;
  for (std::uint32_t op = 0; op < relaxed.operator_count; ++op) {
    RC_ASSERT(relaxed.preconditions.size(op) > 0U);
    for (const std::uint32_t fact : relaxed.preconditions[op])
      by_operator.insert({fact, op});
    for (const std::uint32_t fact : relaxed.effects[op])
      by_operator.insert({fact, op + 1000});
  }
  for (std::uint32_t fact = 0; fact < relaxed.fact_count; ++fact) {
    for (const std::uint32_t op : relaxed.precondition_of[fact])
      by_fact.insert({fact, op});
    for (const std::uint32_t op : relaxed.effect_of[fact])
      by_fact.insert({fact, op + 1000});
  }
  RC_ASSERT(by_operator == by_fact);
}

// What is left out must not matter: h_max with the relevant operators alone is the same.
RC_GTEST_PROP(RelaxedTask, LeavesOutOnlyWhatIsIrrelevant, ()) {
  RandomSource random = oracles::anySource();
  const task::Task task = oracles::randomTask(random);
  const task::FactSet goal = oracles::randomGoal(random, task);
  const RelaxedTask relaxed(task, goal);
  task::Task relevant = task;
  relevant.operators.clear();
  for (task::OperatorId op = 0; op < task.operators.size(); ++op) {
    if (relaxed.parts.size(op) > 0) relevant.operators.push_back(task.operators[op]);
  }
  const oracles::Facts initial = oracles::initialFacts(task);
  RC_ASSERT(oracles::hMax(relevant, initial, goal) == oracles::hMax(task, initial, goal));
}

TEST(RelaxedTask, LeavesOutWhatDoesNotLeadToTheGoal) {
  task::Task task;
  task.facts.resize(4);
  task.operators.push_back({{"useful", {}}, {}, {1}, {}, 4});
  task.operators.push_back({{"useless", {}}, {1}, {2}, {}, 1});
  task.operators.push_back({{"last", {}}, {1}, {3}, {1}, 2});
  const RelaxedTask relaxed(task, task::FactSet{3});
  EXPECT_EQ(relaxed.origin, (std::vector<task::OperatorId>{0, 2}));
  EXPECT_EQ(relaxed.cost, (std::vector<task::Cost>{4, 2, 0}));
  EXPECT_EQ(list(relaxed.preconditions, 0), std::vector<std::uint32_t>{relaxed.true_fact});
  EXPECT_EQ(list(relaxed.preconditions, relaxed.first_goal_operator),
            std::vector<std::uint32_t>{3});
  EXPECT_EQ(list(relaxed.effects, relaxed.first_goal_operator),
            std::vector<std::uint32_t>{relaxed.goal_fact});
}

TEST(RelaxedTask, TakesConditionalEffectsApart) {
  task::Task task;
  task.facts.resize(4);
  task.operators.push_back({{"both", {}}, {0}, {1}, {}, 2, {{{1}, {2}, {}}, {{2}, {}, {1}}}});
  const RelaxedTask relaxed(task, task::Goal(std::vector<task::FactSet>{{1, 2}, {3}}));
  EXPECT_TRUE(relaxed.several_parts);
  EXPECT_EQ(list(relaxed.parts, 0), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(list(relaxed.preconditions, 1), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(list(relaxed.effects, 1), (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(relaxed.operator_count, relaxed.first_goal_operator + 2);
}

}  // namespace
}  // namespace goal_alignment::heuristics
