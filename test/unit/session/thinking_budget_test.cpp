// SPDX-License-Identifier: BSD-3-Clause
#include "session/thinking_budget.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

namespace goal_alignment::session {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

void pass(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

TEST(ThinkingBudget, CountsTurnsAndNotWhatIsBetweenThem) {
  ThinkingBudget budget(kForever, 1000);
  budget.start();
  pass(20);
  budget.stop(&Statistics::ground, 3);
  pass(50);
  EXPECT_GE(budget.statistics().ground, 0.02);
  EXPECT_DOUBLE_EQ(budget.statistics().ground, budget.statistics().total);
  EXPECT_EQ(budget.statistics().planner_calls, 3U);
}

TEST(ThinkingBudget, TakesThePlanOutOfItsTurn) {
  ThinkingBudget budget(kForever, 1000);
  budget.start();
  pass(20);
  budget.addPlanTime(0.015);
  budget.stop(&Statistics::questions, 0);
  const Statistics& spent = budget.statistics();
  EXPECT_DOUBLE_EQ(spent.plan, 0.015);
  EXPECT_NEAR(spent.questions + spent.plan, spent.total, 1e-9);
}

TEST(ThinkingBudget, IsUsedUpUntilItIsRenewed) {
  ThinkingBudget budget(0.01, 1000);
  EXPECT_FALSE(budget.isUsedUp());
  budget.start();
  pass(20);
  budget.stop(&Statistics::parse, 0);
  EXPECT_TRUE(budget.isUsedUp());
  budget.renew();
  EXPECT_FALSE(budget.isUsedUp());
  EXPECT_GT(budget.statistics().total, 0) << "what was counted stays";
}

TEST(ThinkingBudget, OfAnotherTaskIsWhole) {
  ThinkingBudget budget(0.01, 1000);
  budget.start();
  pass(20);
  budget.stop(&Statistics::parse, 7);
  budget.reset();
  EXPECT_FALSE(budget.isUsedUp());
  EXPECT_EQ(budget.statistics().total, 0);
  EXPECT_EQ(budget.statistics().planner_calls, 0U);
}

TEST(ThinkingBudget, ACancelOutlivesANewTaskButNotARenewal) {
  ThinkingBudget budget(kForever, 1000);
  budget.cancel().cancel();
  budget.reset();
  EXPECT_EQ(budget.limits().interruption(), LimitReason::Cancelled);
  EXPECT_EQ(budget.cancelOnly().interruption(), LimitReason::Cancelled);
  budget.renew();
  EXPECT_EQ(budget.limits().interruption(), LimitReason::None);
}

TEST(ThinkingBudget, LimitsAreWhatIsLeft) {
  ThinkingBudget budget(100, 1000);
  budget.start();
  const auto now = Limits::Clock::now();
  EXPECT_EQ(budget.limits().bytes, accountable(1000));
  EXPECT_GT(budget.limits().deadline, now + std::chrono::seconds(90));
  EXPECT_LT(budget.limits(0.75).deadline, now + std::chrono::seconds(30));
  EXPECT_EQ(budget.cancelOnly().deadline, Limits::Clock::time_point::max());
  EXPECT_LT(budget.limitsFor(5).deadline, now + std::chrono::seconds(10));
  budget.setLimits(kForever, 2000);
  EXPECT_EQ(budget.limits(0.75).deadline, Limits::Clock::time_point::max());
  EXPECT_EQ(budget.limits().bytes, accountable(2000));
}

}  // namespace
}  // namespace goal_alignment::session
