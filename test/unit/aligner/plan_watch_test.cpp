// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/plan_watch.h"

#include <gtest/gtest.h>

namespace goal_alignment::aligner {
namespace {

using actionlib_msgs::GoalStatus;
using Standing = PlanWatch::Standing;

GoalStatus goal(const std::string& id, int status) {
  GoalStatus message;
  message.goal_id.id = id;
  message.status = static_cast<std::uint8_t>(status);
  return message;
}

class PlanWatchTest : public testing::Test {
 protected:
  void onPlanPublished(int plan_id, const std::string& identity) {
    watch_.onPlanPublished({plan_id, "tea", "Ann", identity});
  }

  PlanWatch::Clock::time_point now_ = PlanWatch::Clock::now();
  PlanWatch watch_{[this] { return now_; }};
};

TEST_F(PlanWatchTest, nobodyWaitsForAnExecutorThatWasNeverHeard) {
  EXPECT_EQ(watch_.standing(), Standing::Idle);
  onPlanPublished(1, "a");
  EXPECT_EQ(watch_.standing(), Standing::Idle);
  EXPECT_EQ(watch_.nextChange(), PlanWatch::Clock::time_point::max());
}

TEST_F(PlanWatchTest, goalsThatHaveNotEndedKeepItBusy) {
  const std::vector<int> busy = {GoalStatus::PENDING, GoalStatus::ACTIVE, GoalStatus::PREEMPTING};
  for (const int status : busy) {
    watch_.onExecutorStatus({goal("old", GoalStatus::SUCCEEDED), goal("new", status)});
    EXPECT_EQ(watch_.standing(), Standing::Busy) << status;
  }
  const std::vector<int> over = {GoalStatus::SUCCEEDED, GoalStatus::ABORTED,
                                 GoalStatus::PREEMPTED, GoalStatus::REJECTED,
                                 GoalStatus::RECALLING, GoalStatus::RECALLED};
  for (const int status : over) {
    watch_.onExecutorStatus({goal("new", status)});
    EXPECT_EQ(watch_.standing(), Standing::Idle) << status;
  }
}

TEST_F(PlanWatchTest, anExecutorThatFallsSilentIsGone) {
  watch_.onExecutorStatus({goal("g", GoalStatus::ACTIVE)});
  const auto gone = watch_.nextChange();
  EXPECT_GT(gone, now_);
  now_ = gone - std::chrono::milliseconds(1);
  EXPECT_EQ(watch_.standing(), Standing::Busy);
  now_ = gone;
  EXPECT_EQ(watch_.standing(), Standing::Idle);
  watch_.onExecutorStatus({goal("g", GoalStatus::ACTIVE)});
  EXPECT_EQ(watch_.standing(), Standing::Busy) << "it was only slow";
}

TEST_F(PlanWatchTest, aPlanThatWentOutMayBeginAnyMoment) {
  watch_.onExecutorStatus({goal("before", GoalStatus::SUCCEEDED)});
  onPlanPublished(1, "a");
  EXPECT_EQ(watch_.standing(), Standing::Undecided);
  watch_.onExecutorStatus({goal("before", GoalStatus::SUCCEEDED)});
  EXPECT_EQ(watch_.standing(), Standing::Undecided) << "it has not heard of the plan yet";
  watch_.onExecutorStatus(
      {goal("before", GoalStatus::SUCCEEDED), goal("new", GoalStatus::PENDING)});
  EXPECT_EQ(watch_.standing(), Standing::Busy);
  watch_.onExecutorStatus({goal("new", GoalStatus::SUCCEEDED)});
  EXPECT_EQ(watch_.standing(), Standing::Idle) << "it is not expected a second time";
}

TEST_F(PlanWatchTest, countsWhatItHears) {
  EXPECT_EQ(watch_.statusCount(), 0U);
  watch_.onExecutorStatus({});
  watch_.onExecutorStatus({goal("g", GoalStatus::ACTIVE)});
  EXPECT_EQ(watch_.statusCount(), 2U);
}

TEST_F(PlanWatchTest, aPlanWithoutStepsMayBeOverBeforeItIsSeen) {
  watch_.onExecutorStatus({});
  onPlanPublished(1, "a");
  watch_.onExecutorStatus({goal("new", GoalStatus::SUCCEEDED)});
  EXPECT_EQ(watch_.standing(), Standing::Idle);
}

TEST_F(PlanWatchTest, aPlanThatNobodyBeginsIsNotAwaitedForEver) {
  watch_.onExecutorStatus({});
  onPlanPublished(1, "a");
  const auto decided = watch_.nextChange();
  now_ = decided - std::chrono::milliseconds(1);
  EXPECT_EQ(watch_.standing(), Standing::Undecided);
  now_ = decided;
  EXPECT_EQ(watch_.standing(), Standing::Idle);
}

TEST_F(PlanWatchTest, theTaskIsThatOfTheNewestPlanWhileOneIsCarriedOut) {
  watch_.onExecutorStatus({});
  onPlanPublished(1, "a");
  EXPECT_FALSE(watch_.isExecuting("a")) << "not yet";
  watch_.onExecutorStatus({goal("g", GoalStatus::ACTIVE)});
  EXPECT_TRUE(watch_.isExecuting("a"));
  EXPECT_FALSE(watch_.isExecuting("b"));
  EXPECT_EQ(watch_.description(), "plan 1 for the task tea of Ann is being carried out");
  onPlanPublished(2, "a");
  EXPECT_EQ(watch_.description(), "plan 2 for the task tea of Ann is being carried out");
  watch_.onExecutorStatus({goal("g", GoalStatus::SUCCEEDED)});
  EXPECT_FALSE(watch_.isExecuting("a"));
  EXPECT_EQ(watch_.standing(), Standing::Idle) << "the new plan was not for another goal";
}

TEST_F(PlanWatchTest, aPlanOfUnknownOriginIsNamedByItsGoal) {
  watch_.onExecutorStatus({goal("by hand", GoalStatus::ACTIVE)});
  EXPECT_EQ(watch_.description(), "a plan (by hand) is being carried out");
  EXPECT_FALSE(watch_.isExecuting(""));
}

}  // namespace
}  // namespace goal_alignment::aligner
