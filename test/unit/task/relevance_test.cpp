// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/task/relevance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"

namespace goal_alignment::task {
namespace {

RC_GTEST_PROP(Projection, KeepsTheOptimalCost, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const Goal goal = oracles::randomAlternatives(random, task);
  const Projection projection = project(task, goal);
  RC_ASSERT(oracles::optimalCost(projection.task, oracles::initialFacts(projection.task),
                                 projection.goal) ==
            oracles::optimalCost(task, oracles::initialFacts(task), goal));
}

// The same where some operators only delete, which can be what keeps a conditional delete away.
RC_GTEST_PROP(Projection, KeepsTheOptimalCostOfTasksWithMereDeletes, ()) {
  RandomSource random = oracles::anySource();
  Task task = oracles::randomTask(random);
  for (Operator& op : task.operators) {
    if (oracles::chance(random, 0.4)) op.add.clear();
  }
  const Goal goal = oracles::randomGoal(random, task);
  const Projection projection = project(task, goal);
  RC_ASSERT(oracles::optimalCost(projection.task, oracles::initialFacts(projection.task),
                                 projection.goal) ==
            oracles::optimalCost(task, oracles::initialFacts(task), goal));
}

RC_GTEST_PROP(Projection, WhatRunsInItRunsInTheTask, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const Goal goal = oracles::randomAlternatives(random, task);
  const Projection projection = project(task, goal);
  Plan plan;
  oracles::Facts facts = oracles::initialFacts(projection.task);
  for (int step = 0; step < 6; ++step) {
    const auto applicable = oracles::applicableOperators(projection.task, facts);
    if (applicable.empty()) break;
    plan.push_back(applicable[random.below(applicable.size())]);
    facts = oracles::successor(projection.task.operators[plan.back()], facts);
  }
  const auto end = oracles::execute(task, projection.original(plan));
  RC_ASSERT(end.has_value());
  RC_ASSERT(oracles::holds(goal, *end) == oracles::holds(projection.goal, facts));
  RC_ASSERT(cost(task, projection.original(plan)) == cost(projection.task, plan));
}

TEST(Projection, DropsWhatCannotMatter) {
  Task task;
  task.facts.resize(4);
  task.initial = {0, 3};
  task.operators.push_back({{"dear", {}}, {0}, {1}, {}, 4});
  task.operators.push_back({{"cheap", {}}, {0}, {1, 2}, {3}, 2});  // does the same for fact 1
  task.operators.push_back({{"beside", {}}, {1}, {2}, {}, 1});
  task.operators.push_back({{"deletes", {}}, {}, {}, {1}, 0});
  const Projection projection = project(task, FactSet{1});
  EXPECT_EQ(projection.task.facts.size(), 2U);
  EXPECT_EQ(projection.origin, std::vector<OperatorId>{1});
  EXPECT_EQ(projection.task.operators[0].cost, 2);
  EXPECT_TRUE(projection.task.operators[0].del.empty());
  EXPECT_EQ(projection.goal.alternatives, (std::vector<FactSet>{{1}}));
}

TEST(Relevance, ConditionsOfDeletesMatterToo) {
  Task task;
  task.facts.resize(3);
  task.operators.push_back({{"break", {}}, {0}, {1}, {}, 1, {{{2}, {}, {0}}}});
  EXPECT_EQ(relevance(task, FactSet{0, 1}).facts, (std::vector<bool>{true, true, true}));
  EXPECT_EQ(relevance(task, FactSet{2}).facts, (std::vector<bool>{false, false, true}));
}

// Breaking deletes fact 0 where fact 2 is true; only the operator that hides, which adds nothing,
// lets both goals be had.
TEST(Relevance, WhatMakesADeleteAvoidableMatters) {
  Task task;
  task.facts.resize(4);
  task.initial = {0, 2, 3};
  task.operators.push_back({{"break", {}}, {}, {1}, {}, 1, {{{2}, {}, {0}}}});
  task.operators.push_back({{"hide", {}}, {3}, {}, {2}, 1});
  task.operators.push_back({{"beside", {}}, {}, {}, {3}, 1});
  const Relevance relevant = relevance(task, FactSet{0, 1});
  EXPECT_EQ(relevant.operators, (std::vector<bool>{true, true, false}));
  EXPECT_EQ(relevant.facts, (std::vector<bool>{true, true, true, true}));
  const Projection projection = project(task, FactSet{0, 1});
  EXPECT_EQ(oracles::optimalCost(projection.task, oracles::initialFacts(projection.task),
                                 projection.goal),
            2);
}

}  // namespace
}  // namespace goal_alignment::task
