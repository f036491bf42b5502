// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/plan_check.h"

#include <gtest/gtest.h>

#include "samples.h"

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
  EXPECT_EQ(faultOf(plan), "step 2 has no name");
  plan = planOf(2);
  plan.steps[0].action_id = 1;
  EXPECT_EQ(faultOf(plan), "step 1 has action_id 1, expected 0");
}

TEST(MappingFault, namesTheNearestName) {
  any_message::MessageTypes types = test::typesOf({});
  const StepMapping mapping = StepMapping::fromYaml(R"yaml(
tables: {pose: {Kitchen: [0, 0, 0]}}
actions:
  glide: {kind: simulated}
  fly: {kind: simulated, moves: [{frame: base, to: "{pose:tto}"}]}
  swim: {kind: simulated, moves: [{frame: base, to: "{pose:to}"}]}
)yaml",
                                                    "m.yaml", types, std::nullopt);
  const auto faultOfStep = [&](const std::string& name, const std::string& value) {
    Plan plan;
    plan.plan_id = 1;
    plan.steps = {test::step(name, {{"to", value}})};
    return mappingFault(plan, mapping, types);
  };
  EXPECT_EQ(faultOfStep("glied", "kitchen"),
            "nothing says how to carry out step 1 (glied kitchen): m.yaml has no such action; did "
            "you mean 'glide'?");
  EXPECT_EQ(
      faultOfStep("fly", "kitchen"),
      "step 1 (fly kitchen): m.yaml:5:52: the action fly has no parameter 'tto'; did you mean "
      "'to'?");
  EXPECT_EQ(faultOfStep("swim", "kitchne"),
            "step 1 (swim kitchne): m.yaml:6:53: table 'pose' has no entry for 'kitchne'; did you "
            "mean 'Kitchen'?");
  EXPECT_EQ(faultOfStep("swim", "kitchen"), "");
}

}  // namespace
}  // namespace goal_alignment::execution
