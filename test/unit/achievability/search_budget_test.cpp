// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/search_budget.h"

#include <gtest/gtest.h>

namespace goal_alignment::achievability {
namespace {

TEST(SearchBudget, IsMeantLiterallyForTasksOfUsualSize) {
  const SearchBudget budget = scaledTo({}, 2'500);
  EXPECT_EQ(budget.first_greedy, SearchBudget{}.first_greedy);
  EXPECT_EQ(budget.exhaustive, SearchBudget{}.exhaustive);
}

TEST(SearchBudget, LargeTasksGetFewerStates) {
  const SearchBudget given;
  const SearchBudget budget = scaledTo(given, 25'000);
  EXPECT_EQ(budget.first_greedy, given.first_greedy / 10);
  EXPECT_EQ(budget.exhaustive, given.exhaustive / 10);
  EXPECT_EQ(budget.second_greedy, given.second_greedy / 10);
  EXPECT_EQ(budget.shrinking, 500U);
  EXPECT_EQ(budget.parts, given.parts / 10);
  EXPECT_EQ(budget.minimising, given.minimising / 10);
  EXPECT_EQ(budget.first_symbolic, given.first_symbolic);
  EXPECT_EQ(budget.symbolic, given.symbolic);
  EXPECT_EQ(budget.open_sets, given.open_sets);
}

TEST(SearchBudget, NeverGivesMoreThanWasAskedFor) {
  SearchBudget given;
  given.first_greedy = 7;
  EXPECT_EQ(scaledTo(given, 1'000'000).first_greedy, 7U);
  EXPECT_EQ(scaledTo(given, 1'000'000).second_greedy, 500U);
}

TEST(SearchBudget, StatesAndMemoryAreOurs) {
  EXPECT_TRUE(isOwnBudget(LimitReason::States));
  EXPECT_TRUE(isOwnBudget(LimitReason::Memory));
  EXPECT_FALSE(isOwnBudget(LimitReason::Time));
  EXPECT_FALSE(isOwnBudget(LimitReason::Cancelled));
  EXPECT_FALSE(isOwnBudget(LimitReason::None));
}

}  // namespace
}  // namespace goal_alignment::achievability
