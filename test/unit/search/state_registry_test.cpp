// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/state_registry.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "oracles/seeds.h"

namespace goal_alignment::search {
namespace {

using task::State;
using task::Word;

// Far beyond the first table and the first block of states.
TEST(StateRegistry, FindsEveryOfManyStatesAgain) {
  constexpr StateId kStates = 200'000;
  StateRegistry registry(2);
  for (StateId i = 0; i < kStates; ++i) {
    const State state = {Word{i} * 0x10001, ~Word{i}};
    EXPECT_EQ(registry.insert(state.data()), std::make_pair(i, true));
  }
  EXPECT_EQ(registry.size(), kStates);
  for (StateId i = 0; i < kStates; ++i) {
    const State state = {Word{i} * 0x10001, ~Word{i}};
    ASSERT_EQ(registry.insert(state.data()), std::make_pair(i, false));
    ASSERT_TRUE(std::equal(state.begin(), state.end(), registry[i]));
  }
  EXPECT_EQ(registry.size(), kStates);
}

TEST(StateRegistry, StatesNeverMove) {
  StateRegistry registry(1);
  const Word first = 7;
  registry.insert(&first);
  const Word* const place = registry[0];
  for (Word i = 100; i < 20'100; ++i)
    registry.insert(&i);
  EXPECT_EQ(registry[0], place);
  EXPECT_EQ(*place, 7U);
}

RC_GTEST_PROP(StateRegistry, EqualsAMap, ()) {
  RandomSource random = oracles::anySource();
  const std::size_t words = oracles::between(random, 1, 4);
  StateRegistry registry(words);
  std::map<State, StateId> known;
  for (int i = 0; i < 2000; ++i) {
    State state(words);
    for (Word& word : state)
      word = random.below(6) << (random.below(2) * 60);
    const auto [id, is_new] = registry.insert(state.data());
    const auto [entry, expected_new] = known.emplace(state, static_cast<StateId>(known.size()));
    RC_ASSERT(is_new == expected_new);
    RC_ASSERT(id == entry->second);
  }
  RC_ASSERT(registry.size() == known.size());
}

// Equal hashes must not make states equal: insert() takes the hash from outside.
TEST(StateRegistry, TellsStatesOfOneHashApart) {
  StateRegistry registry(1);
  // Fewer than make the table grow: growing hashes anew.
  for (Word i = 0; i < 400; ++i) {
    EXPECT_EQ(registry.insert(&i, 42), std::make_pair(static_cast<StateId>(i), true));
  }
  for (Word i = 0; i < 400; ++i) {
    EXPECT_EQ(registry.insert(&i, 42), std::make_pair(static_cast<StateId>(i), false));
  }
}

TEST(StateRegistry, AccountsForItsGrowth) {
  StateRegistry registry(3);
  const std::size_t empty = registry.bytes();
  for (Word i = 0; i < 10'000; ++i)
    registry.insert(State{i, i, i}.data());
  EXPECT_GE(registry.bytes(), empty + 10'000 * 3 * sizeof(Word));
}

TEST(StateRegistry, ATaskWithoutFactsHasOneState) {
  StateRegistry registry(0);
  const Word nothing = 0;
  EXPECT_TRUE(registry.insert(&nothing).second);
  EXPECT_FALSE(registry.insert(&nothing).second);
}

}  // namespace
}  // namespace goal_alignment::search
