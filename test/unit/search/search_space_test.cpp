// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/search_space.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"
#include "samples.h"

namespace goal_alignment::search {
namespace {

using task::OperatorId;
using task::Task;

TEST(SearchSpace, BeginsWithTheInitialState) {
  const Task task = samples::switches(2);
  const auto search_task = samples::packed(task);
  SearchSpace space(*search_task);
  EXPECT_EQ(space.size(), 1U);
  EXPECT_TRUE(space.plan(SearchSpace::kInitial).empty());
  EXPECT_EQ(oracles::factsOf(task, space.state(SearchSpace::kInitial)), (oracles::Facts{0, 2}));
}

TEST(SearchSpace, AStateKeepsItsFirstWayUntilItIsGivenAnother) {
  const Task task = samples::switches(2);
  const auto search_task = samples::packed(task);
  SearchSpace space(*search_task);
  const StateId left = space.insertSuccessor(SearchSpace::kInitial, 0).first;
  const StateId right = space.insertSuccessor(SearchSpace::kInitial, 2).first;
  const auto [both, is_new] = space.insertSuccessor(left, 2);
  EXPECT_TRUE(is_new);
  EXPECT_EQ(space.insertSuccessor(right, 0), std::make_pair(both, false));
  EXPECT_EQ(space.plan(both), (task::Plan{0, 2}));
  space.setWay(both, right, 0);
  EXPECT_EQ(space.plan(both), (task::Plan{2, 0}));
}

RC_GTEST_PROP(SearchSpace, TheBatchEqualsOneByOne, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const auto search_task = samples::packed(task);
  SearchSpace one_by_one(*search_task);
  SearchSpace in_batches(*search_task);
  for (StateId id = 0; id < one_by_one.size() && id < 50; ++id) {
    const oracles::Facts facts = oracles::factsOf(task, one_by_one.state(id));
    const std::vector<OperatorId> applicable = oracles::applicableOperators(task, facts);
    std::vector<std::pair<StateId, bool>> expected;
    for (const OperatorId op : applicable)
      expected.push_back(one_by_one.insertSuccessor(id, op));
    std::size_t i = 0;
    in_batches.insertSuccessors(id, applicable, [&](StateId successor, bool is_new, OperatorId op) {
      RC_ASSERT(op == applicable[i]);
      RC_ASSERT(std::make_pair(successor, is_new) == expected[i]);
      ++i;
      return true;
    });
    RC_ASSERT(i == applicable.size());
  }
  for (StateId id = 0; id < one_by_one.size(); ++id) {
    RC_ASSERT(in_batches.plan(id) == one_by_one.plan(id));
    RC_ASSERT(oracles::execute(task, in_batches.plan(id)) ==
              oracles::factsOf(task, in_batches.state(id)));
  }
}

}  // namespace
}  // namespace goal_alignment::search
