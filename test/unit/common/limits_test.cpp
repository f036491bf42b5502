// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/limits.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment {
namespace {

TEST(Limits, AFifthOfTheMemoryIsNotAccountedFor) {
  EXPECT_EQ(accountable(1000), 800U);
  EXPECT_EQ(accountable(0), 0U);
}

TEST(LimitMonitor, StopsAfterTheGivenStates) {
  LimitMonitor monitor(Limits{}.withStates(3));
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(monitor.generated(), LimitReason::None) << i;
  EXPECT_EQ(monitor.generated(), LimitReason::States);
  EXPECT_EQ(monitor.states(), 4U);
}

TEST(LimitMonitor, StopsAboveTheGivenBytes) {
  Limits limits;
  limits.bytes = 100;
  LimitMonitor monitor(limits);
  EXPECT_EQ(monitor.generated(100), LimitReason::None);
  EXPECT_EQ(monitor.generated(101), LimitReason::Memory);
}

TEST(LimitMonitor, SeesACancelAtTheNextPoll) {
  CancelToken token;
  Limits limits;
  limits.cancel = &token;
  LimitMonitor monitor(limits);
  EXPECT_EQ(monitor.poll(), LimitReason::None);
  token.cancel();
  EXPECT_EQ(monitor.poll(), LimitReason::Cancelled);
  EXPECT_EQ(monitor.generated(), LimitReason::Cancelled);
  token.reset();
  EXPECT_EQ(monitor.poll(), LimitReason::None);
}

TEST(LimitMonitor, SeesAPastDeadlineWithinSixteenPolls) {
  LimitMonitor monitor(Limits{}.withSeconds(-1));
  LimitReason reason = LimitReason::None;
  for (int i = 0; i < 16 && reason == LimitReason::None; ++i)
    reason = monitor.poll();
  EXPECT_EQ(reason, LimitReason::Time);
}

TEST(LimitMonitor, PollingCountsNoStates) {
  LimitMonitor monitor(Limits{}.withStates(0));
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(monitor.poll(), LimitReason::None);
  EXPECT_EQ(monitor.states(), 0U);
}

TEST(Limits, AreOnlyNarrowed) {
  EXPECT_EQ(Limits{}.withStates(5).withStates(9).states, 5U);
  const Limits soon = Limits{}.withSeconds(1);
  EXPECT_EQ(soon.withSeconds(1000).deadline, soon.deadline);
  EXPECT_LT(soon.withSeconds(0).deadline, soon.deadline);
}

TEST(Limits, AnEndlessTimeIsNoDeadline) {
  const auto never = Limits::Clock::time_point::max();
  EXPECT_EQ(Limits{}.withSeconds(1e300).deadline, never);
  EXPECT_EQ(Limits{}.withSeconds(std::numeric_limits<double>::infinity()).deadline, never);
}

TEST(LimitReached, SaysWhatStoppedAndWhy) {
  const LimitReached reached(LimitReason::Memory, "grounding");
  EXPECT_EQ(reached.reason(), LimitReason::Memory);
  EXPECT_EQ(std::string(reached.what()), "grounding stopped: memory");
}

TEST(Limits, TellWhetherAPersonOrTheClockEndedTheWork) {
  Limits limits;
  EXPECT_EQ(limits.interruption(), LimitReason::None);
  EXPECT_EQ(limits.withStates(0).interruption(), LimitReason::None);
  EXPECT_EQ(limits.withSeconds(0).interruption(), LimitReason::Time);
  CancelToken token;
  limits.cancel = &token;
  EXPECT_EQ(limits.interruption(), LimitReason::None);
  token.cancel();
  EXPECT_EQ(limits.withSeconds(0).interruption(), LimitReason::Cancelled);
}

}  // namespace
}  // namespace goal_alignment
