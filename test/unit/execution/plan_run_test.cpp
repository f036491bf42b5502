// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/plan_run.h"

#include <gtest/gtest.h>

namespace goal_alignment::execution {
namespace {

Plan planOf(int steps) {
  Plan plan;
  plan.plan_id = 1;
  for (int i = 0; i < steps; ++i) {
    ActionDispatch step;
    step.action_id = i;
    step.name = "go";
    plan.steps.push_back(step);
  }
  return plan;
}

TEST(FaultOf, goodPlansHaveNone) {
  EXPECT_EQ(faultOf(planOf(0)), "");
  EXPECT_EQ(faultOf(planOf(3)), "");
}

TEST(FaultOf, saysWhatIsWrong) {
  EXPECT_EQ(faultOf(Plan{}), "this is no plan: plan_id is 0");
  Plan plan = planOf(2);
  plan.steps[1].name.clear();
  EXPECT_EQ(faultOf(plan), "step 1 has no name");
  plan = planOf(2);
  plan.steps[0].action_id = 1;
  EXPECT_EQ(faultOf(plan), "step 0 has action_id 1, expected its index");
}

}  // namespace
}  // namespace goal_alignment::execution
