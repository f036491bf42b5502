// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/priority_queue.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "oracles/seeds.h"

namespace goal_alignment::heuristics {
namespace {

// As Dijkstra uses it: pushes never go below the last key popped. Keys on both sides of the largest
// bucket.
RC_GTEST_PROP(PriorityQueue, PopsInRisingOrder, ()) {
  RandomSource random = oracles::anySource();
  PriorityQueue queue;
  std::multiset<PriorityQueue::Key> expected;
  const std::size_t spread = oracles::chance(random, 0.5) ? 10 : 20'000;
  PriorityQueue::Key last = 0;
  for (std::uint32_t i = 0; i < 300; ++i) {
    if (expected.empty() || oracles::chance(random, 0.6)) {
      const auto key = last + static_cast<PriorityQueue::Key>(random.below(spread));
      queue.push(key, i);
      expected.insert(key);
    } else {
      last = queue.pop().first;
      RC_ASSERT(last == *expected.begin());
      expected.erase(expected.begin());
    }
    RC_ASSERT(queue.empty() == expected.empty());
  }
}

TEST(PriorityQueue, KeepsKeysAndValuesTogether) {
  PriorityQueue queue;
  queue.push(1'000'000, 3);
  queue.push(7, 1);
  queue.push(16'384, 2);
  EXPECT_EQ(queue.pop(), (PriorityQueue::Entry{7, 1}));
  EXPECT_EQ(queue.pop(), (PriorityQueue::Entry{16'384, 2}));
  EXPECT_EQ(queue.pop(), (PriorityQueue::Entry{1'000'000, 3}));
  EXPECT_TRUE(queue.empty());
}

TEST(PriorityQueue, IsEmptyOnceCleared) {
  PriorityQueue queue;
  queue.push(3, 1);
  queue.push(100'000, 2);
  queue.clear();
  EXPECT_TRUE(queue.empty());
  queue.push(1, 9);
  EXPECT_EQ(queue.pop(), (PriorityQueue::Entry{1, 9}));
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace goal_alignment::heuristics
