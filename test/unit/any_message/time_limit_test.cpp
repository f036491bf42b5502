// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/time_limit.h"

#include <gtest/gtest.h>

namespace goal_alignment::any_message {
namespace {

constexpr double kLong = 1000;  // seconds

class RosClock : public testing::Test {
 protected:
  void SetUp() override {
    ros::Time::init();
    ros::Time::setNow(ros::Time(0));
  }
  void TearDown() override { ros::Time::init(); }
};

TEST(TimeLimit, ofNothingIsNever) {
  EXPECT_FALSE(TimeLimit().isOver());
  EXPECT_FALSE(TimeLimit::after(0, ClockKind::Wall).isOver());
  EXPECT_FALSE(TimeLimit::after(0, ClockKind::Ros).isOver());
}

TEST(TimeLimit, ofTheWallIsATimeOnIt) {
  EXPECT_FALSE(TimeLimit::after(kLong, ClockKind::Wall).isOver());
  EXPECT_TRUE(TimeLimit(Clock::now()).isOver());
  EXPECT_TRUE(TimeLimit().capped(Clock::now()).isOver());
  EXPECT_FALSE(TimeLimit().capped(deadlineIn(kLong)).isOver());
}

TEST_F(RosClock, countsFromItsFirstTickAndNotBack) {
  const TimeLimit limit = TimeLimit::after(10, ClockKind::Ros);
  ros::Time::setNow(ros::Time(500));
  EXPECT_FALSE(limit.isOver()) << "it has just begun";
  ros::Time::setNow(ros::Time(506));
  EXPECT_FALSE(limit.isOver());
  ros::Time::setNow(ros::Time(20));
  EXPECT_FALSE(limit.isOver());
  ros::Time::setNow(ros::Time(23));
  EXPECT_FALSE(limit.isOver()) << "9 of 10";
  ros::Time::setNow(ros::Time(24));
  EXPECT_TRUE(limit.isOver());
}

TEST_F(RosClock, thatStandsStillEndsNothing) {
  ros::Time::setNow(ros::Time(500));
  Timer timer(ClockKind::Ros);
  EXPECT_EQ(timer.seconds(), 0);
  EXPECT_EQ(timer.seconds(), 0);
  EXPECT_TRUE(TimeLimit::after(10, ClockKind::Ros).capped(Clock::now()).isOver());
}

}  // namespace
}  // namespace goal_alignment::any_message
