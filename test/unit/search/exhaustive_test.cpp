// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/exhaustive.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"
#include "samples.h"

namespace goal_alignment::search {
namespace {

using oracles::Facts;
using task::Task;

RC_GTEST_PROP(Exhaustive, VisitsEveryReachableStateOnce, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const auto search_task = samples::packed(task);
  Exhaustive exhaustive(*search_task);
  std::set<Facts> visited;
  const LimitReason reason = exhaustive.run({}, [&](StateId id, const task::Word* state) {
    RC_ASSERT(visited.insert(oracles::factsOf(task, state)).second);
    RC_ASSERT(oracles::execute(task, exhaustive.plan(id)) == oracles::factsOf(task, state));
    return true;
  });
  RC_ASSERT(reason == LimitReason::None);
  std::set<Facts> expected;
  for (const auto& [facts, cost] : oracles::reachable(task, oracles::initialFacts(task))) {
    expected.insert(facts);
  }
  RC_ASSERT(visited == expected);
  RC_ASSERT(exhaustive.size() == expected.size());
}

TEST(Exhaustive, PlansAreShortestOnes) {
  const Task task = samples::switches(5);
  const auto search_task = samples::packed(task);
  Exhaustive exhaustive(*search_task);
  const auto visit = [&](StateId id, const task::Word* state) {
    std::size_t on = 0;
    for (task::FactId fact = 1; fact < 10; fact += 2)
      on += task::testBit(state, fact) ? 1 : 0;
    EXPECT_EQ(exhaustive.plan(id).size(), on);
    return true;
  };
  EXPECT_EQ(exhaustive.run({}, visit), LimitReason::None);
}

TEST(Exhaustive, TheVisitorCanEndIt) {
  const Task task = samples::switches(8);
  const auto search_task = samples::packed(task);
  for (const int last : {1, 2, 50}) {
    Exhaustive exhaustive(*search_task);
    int visits = 0;
    const auto reason = exhaustive.run(
        {}, [&](StateId /*id*/, const task::Word* /*state*/) { return ++visits < last; });
    EXPECT_EQ(reason, LimitReason::None);
    EXPECT_EQ(visits, last);
  }
}

TEST(Exhaustive, SaysWhichLimitEndedIt) {
  const Task task = samples::switches(14);
  const auto search_task = samples::packed(task);
  const auto all = [](StateId /*id*/, const task::Word* /*state*/) { return true; };
  EXPECT_EQ(Exhaustive(*search_task).run(Limits{}.withStates(500), all), LimitReason::States);
  EXPECT_EQ(Exhaustive(*search_task).run(Limits{}.withSeconds(-1), all), LimitReason::Time);
  Limits narrow;
  narrow.bytes = 300'000;
  EXPECT_EQ(Exhaustive(*search_task).run(narrow, all), LimitReason::Memory);
}

// "Polled at every generated state": from the cancel on, not one more state is visited.
TEST(Exhaustive, ACancelStopsItWithinOneState) {
  const Task task = samples::switches(12);
  const auto search_task = samples::packed(task);
  for (const int cancel_at : {1, 2, 13, 14, 100, 1000}) {
    CancelToken token;
    Limits limits;
    limits.cancel = &token;
    int visits = 0;
    Exhaustive exhaustive(*search_task);
    const auto reason = exhaustive.run(limits, [&](StateId /*id*/, const task::Word* /*state*/) {
      if (++visits == cancel_at) token.cancel();
      return true;
    });
    EXPECT_EQ(reason, LimitReason::Cancelled);
    EXPECT_EQ(visits, cancel_at);
    EXPECT_LE(exhaustive.size(), static_cast<std::size_t>(cancel_at) + 1);
  }
}

TEST(Exhaustive, GoesOnBeyondManyStates) {
  const Task task = samples::switches(15);
  const auto search_task = samples::packed(task);
  Exhaustive exhaustive(*search_task);
  const auto all = [](StateId /*id*/, const task::Word* /*state*/) { return true; };
  EXPECT_EQ(exhaustive.run({}, all), LimitReason::None);
  EXPECT_EQ(exhaustive.size(), 32'768U);
}

}  // namespace
}  // namespace goal_alignment::search
