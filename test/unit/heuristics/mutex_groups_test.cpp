// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/mutex_groups.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "goal_alignment/common/exceptions.h"
#include "oracles/conditional_task.h"
#include "oracles/seeds.h"

namespace goal_alignment::heuristics {
namespace {

using oracles::Facts;
using task::FactId;
using task::FactSet;
using task::Task;

/// By brute force: every fact in one place, no reachable state with two facts of a group, nor with
/// none where the group says that there is always one.
void checkGroups(const Task& task, const MutexGroups& groups) {
  std::set<FactId> seen;
  for (std::uint32_t group = 0; group < groups.groups().size(); ++group) {
    for (std::uint32_t value = 0; value < groups.groups()[group].size(); ++value) {
      const FactId fact = groups.groups()[group][value];
      RC_ASSERT(seen.insert(fact).second);
      RC_ASSERT(groups.place(fact).group == group);
      RC_ASSERT(groups.place(fact).value == value);
    }
  }
  RC_ASSERT(seen.size() == task.facts.size());
  for (const Facts& state : oracles::conditionallyReachable(task)) {
    for (std::size_t group = 0; group < groups.groups().size(); ++group) {
      std::size_t facts = 0;
      for (const FactId fact : groups.groups()[group])
        facts += state.count(fact);
      RC_ASSERT(facts <= 1);
      RC_ASSERT(facts == 1 || !groups.exactlyOne(group));
    }
  }
}

RC_GTEST_PROP(MutexGroups, OfPairsAreMutexGroups, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  checkGroups(task, groupsFromPairs(task, MutexTable(task, {}), {}));
}

RC_GTEST_PROP(MutexGroups, OfInvariantsAreMutexGroups, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  checkGroups(task, groupsFromInvariants(task, {}));
}

RC_GTEST_PROP(MutexGroups, OfInvariantsHoldDespiteConditionalEffects, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomConditionalTask(random);
  checkGroups(task, groupsFromInvariants(task, {}));
}

/// A token on three places in a line and a lamp that burns out: what is exactly one, and what is
/// none after a while.
Task tokenAndLamp() {
  Task task;
  task.facts.resize(5);
  const auto move = [&](FactId from, FactId to) {
    task.operators.push_back({{"move", {}}, {from}, {to}, {from}, 1});
  };
  move(0, 1);
  move(1, 0);
  move(1, 2);
  move(2, 1);
  task.operators.push_back({{"switch off", {}}, {3}, {4}, {3}, 1});
  task.operators.push_back({{"burn out", {}}, {3}, {}, {3}, 1});
  task.initial = {0, 3};
  return task;
}

TEST(MutexGroups, BothWaysFindTheTokenAndTheLamp) {
  const Task task = tokenAndLamp();
  for (const MutexGroups& groups :
       {groupsFromPairs(task, MutexTable(task, {}), {}), groupsFromInvariants(task, {})}) {
    ASSERT_EQ(groups.groups(), (std::vector<FactSet>{{0, 1, 2}, {3, 4}}));
    EXPECT_TRUE(groups.exactlyOne(0));
    EXPECT_FALSE(groups.exactlyOne(1));
    EXPECT_EQ(groups.valueCount(0), 3U);
    EXPECT_EQ(groups.valueCount(1), 3U);
  }
}

TEST(MutexGroups, AConditionalDeleteMayEmptyAGroup) {
  Task task = tokenAndLamp();
  task.operators.push_back({{"quake", {}}, {}, {}, {}, 1, {{{4}, {}, {2}}}});
  EXPECT_FALSE(groupsFromInvariants(task, {}).exactlyOne(0));
}

TEST(MutexGroups, StopAtTheirLimits) {
  const Task task = tokenAndLamp();
  const MutexTable mutexes(task, {});
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(groupsFromPairs(task, mutexes, limits), LimitReached);
  EXPECT_THROW(groupsFromInvariants(task, limits), LimitReached);
  Limits narrow;
  narrow.bytes = 8;
  EXPECT_THROW(groupsFromPairs(task, mutexes, narrow), LimitReached);
}

}  // namespace
}  // namespace goal_alignment::heuristics
