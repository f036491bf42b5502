// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/task_repeats.h"

#include <gtest/gtest.h>

namespace goal_alignment::aligner {
namespace {

using Verdict = TaskRepeats::Verdict;
using std::chrono::milliseconds;

class TaskRepeatsTest : public testing::Test {
 protected:
  Verdict after(int pause, bool under_way, const std::string& publisher = "/app",
                const std::string& identity = "tea") {
    now_ += milliseconds(pause);
    return repeats_.judge(publisher, identity, under_way, now_);
  }

  TaskRepeats::Clock::time_point now_ = TaskRepeats::Clock::now();
  TaskRepeats repeats_;
};

TEST_F(TaskRepeatsTest, whatIsUnderWayIsRepeatedAndToldOnce) {
  EXPECT_EQ(after(0, false), Verdict::Wanted);
  EXPECT_EQ(after(100, true), Verdict::RepeatedToTell);
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ(after(100, true), Verdict::Repeated);
}

TEST_F(TaskRepeatsTest, aStreamStaysOneWishWhenTheTaskIsDone) {
  after(0, false);
  after(100, true);
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ(after(100, false), Verdict::Repeated);
  EXPECT_EQ(after(1000, false), Verdict::Repeated) << "rostopic pub -r 1";
  EXPECT_EQ(after(2000, false), Verdict::Wanted) << "wanted again";
}

TEST_F(TaskRepeatsTest, aStreamOfATaskThatTakesNoTimeIsOneWishToo) {
  EXPECT_EQ(after(0, false), Verdict::Wanted);
  EXPECT_EQ(after(100, false), Verdict::RepeatedToTell);
  EXPECT_EQ(after(100, false), Verdict::Repeated);
}

TEST_F(TaskRepeatsTest, whoPressesAgainAfterTheResultIsHeardOnce) {
  EXPECT_EQ(after(0, false), Verdict::Wanted);
  EXPECT_EQ(after(600, false), Verdict::Wanted);
  EXPECT_EQ(after(600, false), Verdict::RepeatedToTell);
}

TEST_F(TaskRepeatsTest, whoWantsItAgainAfterItIsDoneGetsIt) {
  EXPECT_EQ(after(0, false), Verdict::Wanted);
  EXPECT_EQ(after(3000, false), Verdict::Wanted);
  EXPECT_EQ(after(3000, true), Verdict::RepeatedToTell);
  EXPECT_EQ(after(3000, false), Verdict::Wanted);
}

TEST_F(TaskRepeatsTest, othersAndOtherTasksAreJudgedOnTheirOwn) {
  after(0, false);
  after(100, true);
  EXPECT_EQ(after(100, false, "/other"), Verdict::Wanted);
  EXPECT_EQ(after(0, false, "/app", "coffee"), Verdict::Wanted);
  EXPECT_EQ(after(0, false), Verdict::Repeated);
}

TEST_F(TaskRepeatsTest, aLongStreamIsToldOfNowAndThen) {
  after(0, false);
  int told = 0;
  for (int i = 0; i < 1300; ++i)
    told += after(100, true) == Verdict::RepeatedToTell ? 1 : 0;
  EXPECT_EQ(told, 3);
}

}  // namespace
}  // namespace goal_alignment::aligner
