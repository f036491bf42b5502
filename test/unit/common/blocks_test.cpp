// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/blocks.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace goal_alignment {
namespace {

TEST(BlockVector, KeepsWhatWasPushedAcrossBlocks) {
  BlockVector<int> numbers;
  EXPECT_TRUE(numbers.empty());
  for (int i = 0; i < 5000; ++i)
    numbers.push_back(i);
  const int* const first = &numbers[0];
  for (int i = 5000; i < 10'000; ++i)
    numbers.push_back(i);
  EXPECT_EQ(&numbers[0], first);
  ASSERT_EQ(numbers.size(), 10'000U);
  int expected = 0;
  for (const int number : numbers)
    ASSERT_EQ(number, expected++);
  EXPECT_EQ(expected, 10'000);
}

TEST(ArrayStore, KeepsArraysOfAllSizesWhereTheyAre) {
  ArrayStore<int> store;
  std::vector<Span<int>> kept;
  std::vector<std::vector<int>> arrays;
  for (int i = 0; i < 300; ++i) {
    arrays.emplace_back(static_cast<std::size_t>(i * i % 997), i);
    kept.push_back(store.keep(arrays.back()));
  }
  arrays.emplace_back(100'000, 7);  // larger than a block
  kept.push_back(store.keep(arrays.back()));
  const ArrayStore<int> moved = std::move(store);
  for (std::size_t i = 0; i < arrays.size(); ++i)
    EXPECT_EQ(kept[i], Span<int>(arrays[i]));
}

}  // namespace
}  // namespace goal_alignment
