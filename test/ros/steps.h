// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "plan_runs.h"

namespace goal_alignment::test {

/// plan_executor alone, with servers, services and components of the test's own.
class Steps : public testing::Test, protected PlanRuns {
 protected:
  Steps() : PlanRuns(ros::NodeHandle{}) {}

  // On a loaded machine links take their time; what is to be missed has less patience of its own.
  void SetUp() override { ros::param::set("/plan_executor/servers_timeout", kPatience); }

  void expectFailure(const ExecutePlanResult& result, int outcome, const std::string& reason) {
    EXPECT_EQ(execute_.getState(), actionlib::SimpleClientGoalState::ABORTED);
    EXPECT_EQ(result.outcome, outcome);
    EXPECT_EQ(result.failed_step, 0);
    EXPECT_NE(result.reason.find(reason), std::string::npos) << result.reason;
  }

  void cancelWhileItRuns(const Plan& plan, const std::function<bool()>& it_runs) {
    send(plan);
    ASSERT_TRUE(eventually(it_runs));
    cancelKnownGoal(execute_);
    const ExecutePlanResult result = awaitEnd();
    EXPECT_EQ(execute_.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
    EXPECT_EQ(result.outcome, ExecutePlanResult::CANCELED);
    EXPECT_EQ(result.failed_step, 0);
    EXPECT_NE(result.reason.find("stopped during step 1"), std::string::npos) << result.reason;
  }

  ros::NodeHandle node_;
};

}  // namespace goal_alignment::test
