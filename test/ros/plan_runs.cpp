// SPDX-License-Identifier: BSD-3-Clause
#include "plan_runs.h"

#include "graph.h"

namespace goal_alignment::test {

Plan planOf(const std::vector<Step>& steps) {
  static int plan_id = 1000;
  Plan plan;
  plan.plan_id = ++plan_id;
  for (const auto& [name, parameters] : steps) {
    ActionDispatch step;
    step.action_id = static_cast<int>(plan.steps.size());
    step.plan_id = plan.plan_id;
    step.name = name;
    for (const auto& [key, value] : parameters) {
      step.parameters.emplace_back();
      step.parameters.back().key = key;
      step.parameters.back().value = value;
    }
    plan.steps.push_back(step);
  }
  return plan;
}

std::string doneBy(const ExecutePlanResult& result) {
  std::string text;
  for (const PlanStep& step : result.done) {
    text += (text.empty() ? "(" : " (") + step.name;
    for (const std::string& arg : step.args)
      text += " " + arg;
    text += ")";
  }
  return text;
}

void PlanRuns::setMapping(const std::string& yaml) {
  const std::string file = folder_.path() + "/mapping" + std::to_string(++mappings_) + ".yaml";
  writeText(file, yaml);
  ros::param::set("/plan_executor/mapping", file);
}

void PlanRuns::send(const Plan& plan) {
  ASSERT_TRUE(isLinked(execute_, "/plan_executor", "/execute_plan"));
  for (const char* topic : {"/action_dispatch", "/action_feedback"})
    ASSERT_TRUE(eventually([&] { return reachesUs("/plan_executor", topic); })) << topic;
  ExecutePlanGoal goal;
  goal.plan = plan;
  execute_.sendGoal(goal);
}

ExecutePlanResult PlanRuns::awaitEnd() {
  EXPECT_TRUE(eventually([this] { return execute_.getState().isDone(); })) << "no end";
  const auto result = execute_.getResult();
  return result ? *result : ExecutePlanResult{};
}

ExecutePlanResult PlanRuns::run(const Plan& plan) {
  send(plan);
  return awaitEnd();
}

bool PlanRuns::dispatched(const Plan& plan, int step) {
  return dispatches_
      .waitFor([&](const ActionDispatch& dispatch) {
        return dispatch.plan_id == plan.plan_id && dispatch.action_id == step;
      })
      .has_value();
}

}  // namespace goal_alignment::test
