// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/state_packing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"
#include "samples.h"

namespace goal_alignment::search {
namespace {

using task::Task;
using task::Word;

std::vector<Word> packedState(const StatePacking& packing, const Task& task,
                              const oracles::Facts& facts) {
  std::vector<Word> packed(packing.words());
  packing.pack(oracles::stateOf(task, facts).data(), packed.data());
  return packed;
}

RC_GTEST_PROP(StatePacking, UnpacksToWhatWasPacked, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const auto search_task = samples::packed(task);
  const StatePacking& packing = search_task->packing();
  for (const auto& [facts, cost] : oracles::reachable(task, oracles::initialFacts(task))) {
    const std::vector<Word> packed = packedState(packing, task, facts);
    task::State state(task::wordsFor(task.facts.size()));
    packing.unpack(packed.data(), state.data());
    RC_ASSERT(oracles::factsOf(task, state.data()) == facts);
  }
}

RC_GTEST_PROP(StatePacking, AppliesOperatorsAsTheirDefinitionSays, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const auto search_task = samples::packed(task);
  const StatePacking& packing = search_task->packing();
  for (const auto& [facts, cost] : oracles::reachable(task, oracles::initialFacts(task))) {
    const std::vector<Word> packed = packedState(packing, task, facts);
    for (const task::OperatorId op : oracles::applicableOperators(task, facts)) {
      std::vector<Word> successor(packing.words());
      packing.apply(op, packed.data(), successor.data());
      RC_ASSERT(successor ==
                packedState(packing, task, oracles::successor(task.operators[op], facts)));
    }
  }
}

RC_GTEST_PROP(StatePacking, SeesGoalsInPackedStates, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const auto search_task = samples::packed(task);
  const StatePacking& packing = search_task->packing();
  const StatePacking::Goal packed_goal = packing.goal(goal);
  for (const auto& [facts, cost] : oracles::reachable(task, oracles::initialFacts(task))) {
    RC_ASSERT(packed_goal.holdsIn(packedState(packing, task, facts).data()) ==
              oracles::holds(goal, facts));
  }
}

TEST(StatePacking, TakesABitForASwitchAndNoFieldLiesAcrossWords) {
  EXPECT_EQ(samples::packed(samples::switches(64))->packing().words(), 1U);
  EXPECT_EQ(samples::packed(samples::switches(65))->packing().words(), 2U);
  EXPECT_EQ(SearchTask(samples::switches(65)).packing().words(), 3U) << "a bit a fact";
}

}  // namespace
}  // namespace goal_alignment::search
