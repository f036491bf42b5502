// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/mutexes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "goal_alignment/common/exceptions.h"
#include "oracles/heuristics.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"

namespace goal_alignment::heuristics {
namespace {

using oracles::Pair;
using task::FactId;
using task::Task;

std::set<Pair> possible(const Task& task, const MutexTable& table) {
  std::set<Pair> pairs;
  for (FactId f = 0; f < task.facts.size(); ++f) {
    for (FactId g = f; g < task.facts.size(); ++g) {
      if (!table.mutex(f, g)) pairs.insert({f, g});
    }
  }
  return pairs;
}

RC_GTEST_PROP(MutexTable, EqualsTheDefinitionOfH2, ()) {
  RandomSource random = oracles::anySource();
  oracles::TaskSize size;
  size.conditional = false;
  const Task task = oracles::randomTask(random, size);
  const MutexTable table(task, {});
  RC_ASSERT(possible(task, table) == oracles::possiblePairs(task));
  for (FactId f = 0; f < task.facts.size(); ++f) {
    for (FactId g = 0; g < task.facts.size(); ++g) {
      RC_ASSERT(table.mutex(f, g) == table.mutex(g, f));
    }
  }
}

RC_GTEST_PROP(MutexTable, NeverRulesOutWhatIsReachable, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const MutexTable table(task, {});
  for (const auto& [f, g] : oracles::reachablePairs(task))
    RC_ASSERT(!table.mutex(f, g));
  std::set<GroundName> kept;
  for (const task::Operator& op : table.withoutInapplicable(task).operators)
    kept.insert(op.name);
  for (const auto& [facts, way] : oracles::reachable(task, oracles::initialFacts(task))) {
    for (const task::OperatorId op : oracles::applicableOperators(task, facts)) {
      RC_ASSERT(kept.count(task.operators[op].name) > 0);
    }
    RC_ASSERT(!table.contains({facts.begin(), facts.end()}));
  }
}

// Rows of several words, and operators without preconditions among the others.
RC_GTEST_PROP(MutexTable, EqualsTheDefinitionBeyondOneWord, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random, {63, 66, 30, 50, 3, 0, false});
  RC_ASSERT(possible(task, MutexTable(task, {})) == oracles::possiblePairs(task));
}

Task oneToken() {
  Task task;
  task.facts.resize(4);  // the last one is unreachable
  task.operators.push_back({{"right", {}}, {0}, {1}, {0}, 1});
  task.operators.push_back({{"further", {}}, {1}, {2}, {1}, 1});
  task.operators.push_back({{"never", {}}, {0, 1}, {3}, {}, 1});
  task.initial = {0};
  return task;
}

TEST(MutexTable, NamesThePairItFinds) {
  const MutexTable table(oneToken(), {});
  task::FactSet pair;
  EXPECT_TRUE(table.contains({0, 2}, &pair));
  EXPECT_EQ(pair, (task::FactSet{0, 2}));
  EXPECT_TRUE(table.contains({2, 3}, &pair));
  EXPECT_EQ(pair, (task::FactSet{2, 3}));
  EXPECT_TRUE(table.contains({3}, &pair));
  EXPECT_EQ(pair, (task::FactSet{3}));
  EXPECT_FALSE(table.contains({1}));
  EXPECT_FALSE(table.contains({}));
}

TEST(MutexTable, TakesOutWhatCanNeverBeApplied) {
  const Task task = oneToken();
  const Task without = MutexTable(task, {}).withoutInapplicable(task);
  ASSERT_EQ(without.operators.size(), 2U);
  EXPECT_EQ(without.operators[0].name.name, "right");
  EXPECT_EQ(without.operators[1].name.name, "further");
  EXPECT_EQ(without.facts.size(), task.facts.size());
  EXPECT_EQ(without.initial, task.initial);
}

TEST(MutexTable, StopsAtItsLimits) {
  const Task task = oneToken();
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(MutexTable(task, limits), LimitReached);
}

TEST(MutexTable, KnowsNothingWhereItWouldNotFit) {
  const Task task = oneToken();
  Limits narrow;
  narrow.bytes = 8;
  const MutexTable table(task, narrow);
  EXPECT_FALSE(table.known());
  EXPECT_FALSE(table.contains(task::FactSet{0, 1, 2}));
  EXPECT_EQ(table.withoutInapplicable(task).operators.size(), task.operators.size());
}

}  // namespace
}  // namespace goal_alignment::heuristics
