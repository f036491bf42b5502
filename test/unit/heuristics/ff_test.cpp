// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/ff.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "oracles/heuristics.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"

namespace goal_alignment::heuristics {
namespace {

using oracles::Facts;
using task::Cost;
using task::Task;

RC_GTEST_PROP(Ff, IsInfiniteExactlyWhereTheRelaxationIs, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::FactSet goal = oracles::randomGoal(random, task);
  Ff ff(task, goal);
  for (const auto& [facts, way] : oracles::reachable(task, oracles::initialFacts(task))) {
    const Cost h = ff.evaluate(oracles::stateOf(task, facts).data());
    RC_ASSERT((h == kInfinity) == !oracles::hMax(task, facts, goal).has_value());
    RC_ASSERT((h == 0) == oracles::holds(goal, facts));
  }
}

// A relaxed plan reaches everything h_max needs, so it can't cost less.
RC_GTEST_PROP(Ff, IsNeverBelowHMax, ()) {
  RandomSource random = oracles::anySource();
  oracles::TaskSize size;
  size.least_cost = 1;
  const Task task = oracles::randomTask(random, size);
  const task::FactSet goal = oracles::randomGoal(random, task);
  const Facts initial = oracles::initialFacts(task);
  const auto h_max = oracles::hMax(task, initial, goal);
  RC_PRE(h_max.has_value());
  RC_ASSERT(Ff(task, goal).evaluate(task::initialState(task).data()) >= *h_max);
}

RC_GTEST_PROP(Ff, PreferredOperatorsAreApplicableAndNamedOnce, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::FactSet goal = oracles::randomGoal(random, task);
  Ff ff(task, goal);
  for (const auto& [facts, way] : oracles::reachable(task, oracles::initialFacts(task))) {
    const Cost h = ff.evaluate(oracles::stateOf(task, facts).data());
    std::set<task::OperatorId> preferred;
    for (const task::OperatorId op : ff.preferred()) {
      RC_ASSERT(preferred.insert(op).second);
      RC_ASSERT(oracles::holds(task.operators[op].precondition, facts));
    }
    // Every relaxed plan begins somewhere.
    RC_ASSERT(preferred.empty() == (h == 0 || h == kInfinity));
  }
}

TEST(Ff, CountsSharedOperatorsOnceAndFreeOnesAsOne) {
  Task task;
  task.facts.resize(4);
  task.operators.push_back({{"both", {}}, {0}, {1}, {}, 0});
  task.operators.push_back({{"left", {}}, {1}, {2}, {}, 2});
  task.operators.push_back({{"right", {}}, {1}, {3}, {}, 3});
  task.initial = {0};
  const task::State state = task::initialState(task);
  Ff ff(task, task::FactSet{2, 3});
  EXPECT_EQ(ff.evaluate(state.data()), 6);
  EXPECT_EQ(ff.preferred(), (std::vector<task::OperatorId>{0}));
}

}  // namespace
}  // namespace goal_alignment::heuristics
