// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatus.h>

#include <string>
#include <vector>

#include "scenario.h"

namespace goal_alignment::test {

/// Goals and cancels with ids of our own: SimpleActionClient remembers one goal at a time only.
class GoalsByHand : public Scenario {
 protected:
  GoalsByHand()
      : results_(node_, "/goal_alignment/align/result"),
        goals_(node_.advertise<AlignActionGoal>("/goal_alignment/align/goal", 1000)),
        cancels_(node_.advertise<actionlib_msgs::GoalID>("/goal_alignment/align/cancel", 1000)) {}

  void SetUp() override {
    Scenario::SetUp();
    ASSERT_TRUE(eventually(
        [this] { return goals_.getNumSubscribers() > 0 && cancels_.getNumSubscribers() > 0; }));
  }

  std::string send(const AlignGoal& goal) {
    AlignActionGoal message;
    message.goal_id.id = newId();
    message.goal_id.stamp = ros::Time::now();
    message.goal = goal;
    goals_.publish(message);
    return message.goal_id.id;
  }

  static std::string newId() {
    static int number = 0;
    return ros::this_node::getName() + "-by-hand-" + std::to_string(++number);
  }

  void cancel(const std::string& id) {
    actionlib_msgs::GoalID message;
    message.id = id;
    cancels_.publish(message);
  }

  AlignActionResult resultOf(const std::string& id) {
    const auto result = results_.waitFor(
        [&](const AlignActionResult& shown) { return shown.status.goal_id.id == id; });
    EXPECT_TRUE(result) << "no result for " << id;
    return result.value_or(AlignActionResult{});
  }

  std::size_t resultsOf(const std::string& id) const {
    const auto all = results_.all();
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(),
        [&](const AlignActionResult& shown) { return shown.status.goal_id.id == id; }));
  }

  static void expectCanceled(const AlignActionResult& result, int status) {
    EXPECT_EQ(int{result.status.status}, status);
    EXPECT_EQ(result.result.outcome, AlignResult::CANCELED);
    EXPECT_FALSE(result.result.message.empty());
    EXPECT_EQ(result.result.failing_step, -1);
  }

  Topic<AlignActionResult> results_;
  ros::Publisher goals_;
  ros::Publisher cancels_;
};

}  // namespace goal_alignment::test
