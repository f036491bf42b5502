// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/successor_generator.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"

namespace goal_alignment::search {
namespace {

std::vector<task::OperatorId> visited(const SuccessorGenerator& successors,
                                      const task::State& state) {
  std::vector<task::OperatorId> operators;
  successors.forEach(state.data(), [&](task::OperatorId op) { operators.push_back(op); });
  return operators;
}

RC_GTEST_PROP(SuccessorGenerator, FindsWhatTestingEveryOperatorFinds, ()) {
  RandomSource random = oracles::anySource();
  const oracles::TaskSize large = {50, 140, 40, 200};
  const task::Task task =
      oracles::randomTask(random, oracles::chance(random, 0.5) ? large : oracles::TaskSize{});
  const SuccessorGenerator successors(task);
  for (int i = 0; i < 10; ++i) {
    oracles::Facts facts;
    const double share = random.unit();
    for (task::FactId fact = 0; fact < task.facts.size(); ++fact) {
      if (oracles::chance(random, share)) facts.insert(fact);
    }
    std::vector<task::OperatorId> found = visited(successors, oracles::stateOf(task, facts));
    std::sort(found.begin(), found.end());
    RC_ASSERT(found == oracles::applicableOperators(task, facts));
  }
}

RC_GTEST_PROP(SuccessorGenerator, OrderDependsOnTheTaskAlone, ()) {
  RandomSource random = oracles::anySource();
  const task::Task task = oracles::randomTask(random);
  const task::State state = task::initialState(task);
  RC_ASSERT(visited(SuccessorGenerator(task), state) == visited(SuccessorGenerator(task), state));
}

TEST(SuccessorGenerator, AnEmptyTaskHasNoSuccessors) {
  EXPECT_TRUE(visited(SuccessorGenerator(task::Task{}), task::State{}).empty());
}

// Several operators may need the very same facts.
TEST(SuccessorGenerator, KeepsOperatorsWithEqualPreconditionsApart) {
  task::Task task;
  task.facts.resize(2);
  for (int i = 0; i < 3; ++i)
    task.operators.push_back({{"o", {}}, {1}, {0}, {}, 1});
  task.operators.push_back({{"free", {}}, {}, {1}, {}, 1});
  task.initial = {1};
  EXPECT_EQ(visited(SuccessorGenerator(task), task::initialState(task)).size(), 4U);
  EXPECT_EQ(visited(SuccessorGenerator(task), task::State{0}).size(), 1U);
}

}  // namespace
}  // namespace goal_alignment::search
