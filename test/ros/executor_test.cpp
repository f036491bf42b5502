// SPDX-License-Identifier: BSD-3-Clause
// simulated_executor: plans run step by step, through execute_plan alone.
#include <actionlib/client/simple_action_client.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <csignal>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/ActionFeedback.h"
#include "goal_alignment/ExecutePlanAction.h"
#include "graph.h"
#include "program.h"
#include "scenario.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;
using Client = ActionClient<ExecutePlanAction>;

bool offersOther(const std::string& node) {
  return reachesUs(node, "/other/execute_plan/status");
}

class Executor : public testing::Test {
 protected:
  Executor()
      : dispatches_(node_, "/action_dispatch"),
        feedback_(node_, "/action_feedback"),
        client_(node_, "/execute_plan") {}

  void SetUp() override {
    ros::param::set("/simulated_executor/step_duration", 0.01);
    ros::param::set("/simulated_executor/failing_step", -1);
    ASSERT_TRUE(isLinked(client_, "/simulated_executor", "/execute_plan"));
    for (const char* topic : {"/action_dispatch", "/action_feedback"})
      ASSERT_TRUE(eventually([&] { return reachesUs("/simulated_executor", topic); })) << topic;
    publisher_ = node_.advertise<Plan>("/goal_alignment/plan", 1, true);
  }

  static ExecutePlanGoal planOf(int steps) {
    static int plan_id = 0;
    ExecutePlanGoal goal;
    goal.plan.plan_id = ++plan_id;
    for (int i = 0; i < steps; ++i) {
      ActionDispatch dispatch;
      dispatch.action_id = i;
      dispatch.plan_id = plan_id;
      dispatch.name = "step" + std::to_string(i);
      goal.plan.steps.push_back(dispatch);
    }
    return goal;
  }

  ExecutePlanResult run(const ExecutePlanGoal& goal) {
    client_.sendGoal(goal);
    EXPECT_TRUE(eventually([this] { return client_.getState().isDone(); }));
    const auto result = client_.getResult();
    return result ? *result : ExecutePlanResult{};
  }

  bool succeeded(const ExecutePlanGoal& goal, int step) {
    return feedback_
        .waitFor([&](const ActionFeedback& f) {
          return f.plan_id == goal.plan.plan_id && f.action_id == step &&
                 f.status == ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE;
        })
        .has_value();
  }

  ros::NodeHandle node_;
  Topic<ActionDispatch> dispatches_;
  Topic<ActionFeedback> feedback_;
  Client client_;
  ros::Publisher publisher_;
};

TEST_F(Executor, dispatchesEveryStepInOrder) {
  const ExecutePlanGoal goal = planOf(3);
  client_.sendGoal(goal);
  ASSERT_TRUE(eventually([this] { return client_.getState().isDone(); }));
  EXPECT_EQ(client_.getState(), State::SUCCEEDED);
  EXPECT_EQ(client_.getResult()->outcome, ExecutePlanResult::SUCCESS);
  EXPECT_EQ(client_.getResult()->failed_step, -1);
  ASSERT_TRUE(succeeded(goal, 2));
  ASSERT_TRUE(dispatches_.waitFor([&](const ActionDispatch& dispatch) {
    return dispatch.plan_id == goal.plan.plan_id && dispatch.action_id == 2;
  }));
  std::vector<std::string> names;
  float last = 0;
  for (const ActionDispatch& dispatch : dispatches_.all()) {
    if (dispatch.plan_id != goal.plan.plan_id) continue;
    names.push_back(dispatch.name);
    EXPECT_GE(dispatch.dispatch_time, last);
    last = dispatch.dispatch_time;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"step0", "step1", "step2"}));
}

TEST_F(Executor, hasNothingToDoForAnEmptyPlan) {
  EXPECT_EQ(run(planOf(0)).outcome, ExecutePlanResult::SUCCESS);
  EXPECT_EQ(client_.getState(), State::SUCCEEDED);
}

TEST_F(Executor, refusesWhatIsNoPlan) {
  EXPECT_EQ(run(ExecutePlanGoal{}).outcome, ExecutePlanResult::INVALID_PLAN);
  EXPECT_EQ(client_.getState(), State::REJECTED);
  ExecutePlanGoal goal = planOf(2);
  goal.plan.steps[1].action_id = 7;
  const ExecutePlanResult result = run(goal);
  EXPECT_EQ(result.outcome, ExecutePlanResult::INVALID_PLAN);
  EXPECT_EQ(result.reason, "step 2 has action_id 7, expected 1");
  goal = planOf(1);
  goal.plan.guaranteed.resize(1);
  goal.plan.guaranteed[0].text = "tea is served";
  EXPECT_EQ(run(goal).outcome, ExecutePlanResult::INVALID_PLAN);
  EXPECT_NE(client_.getResult()->reason.find("guaranteed"), std::string::npos)
      << client_.getResult()->reason;
}

TEST_F(Executor, refusesToRunWithABrokenParameterAndNamesIt) {
  ros::param::set("/simulated_executor/step_duration", -1.0);
  const ExecutePlanResult result = run(planOf(1));
  EXPECT_EQ(result.outcome, ExecutePlanResult::INVALID_PLAN);
  EXPECT_NE(result.reason.find("/simulated_executor/step_duration"), std::string::npos);
}

TEST_F(Executor, namesTheStepThatFails) {
  ros::param::set("/simulated_executor/failing_step", 1);
  const ExecutePlanGoal goal = planOf(3);
  const ExecutePlanResult result = run(goal);
  EXPECT_EQ(client_.getState(), State::ABORTED);
  EXPECT_EQ(result.outcome, ExecutePlanResult::STEP_FAILED);
  EXPECT_EQ(result.failed_step, 1);
  EXPECT_NE(result.reason.find("step1"), std::string::npos);
  for (const ActionDispatch& dispatch : dispatches_.all()) {
    EXPECT_FALSE(dispatch.plan_id == goal.plan.plan_id && dispatch.action_id == 2);
  }
}

TEST_F(Executor, stopsAtOnceWhenCanceled) {
  ros::param::set("/simulated_executor/step_duration", 3600.0);
  const ExecutePlanGoal goal = planOf(2);
  client_.sendGoal(goal);
  ASSERT_TRUE(
      dispatches_.waitFor([&](const ActionDispatch& d) { return d.plan_id == goal.plan.plan_id; }));
  cancelKnownGoal(client_);
  ASSERT_TRUE(eventually([this] { return client_.getState().isDone(); }));
  EXPECT_EQ(client_.getState(), State::PREEMPTED);
  EXPECT_EQ(client_.getResult()->outcome, ExecutePlanResult::CANCELED);
  EXPECT_EQ(client_.getResult()->failed_step, 0);
}

TEST_F(Executor, leavesAPlanForANewerOne) {
  ros::param::set("/simulated_executor/step_duration", 3600.0);
  const ExecutePlanGoal old = planOf(1);
  client_.sendGoal(old);
  ASSERT_TRUE(
      dispatches_.waitFor([&](const ActionDispatch& d) { return d.plan_id == old.plan.plan_id; }));
  ros::param::set("/simulated_executor/step_duration", 0.0);
  Client other(node_, "/execute_plan");
  ASSERT_TRUE(eventually([&] { return other.isServerConnected(); }));
  other.sendGoal(planOf(1));
  EXPECT_TRUE(eventually([&] { return other.getState().isDone(); }));
  EXPECT_EQ(other.getState(), State::SUCCEEDED);
  EXPECT_TRUE(eventually([this] { return client_.getState().isDone(); }));
  EXPECT_EQ(client_.getState(), State::PREEMPTED);
}

TEST_F(Executor, doesNotActOnThePublishedPlan) {
  const ExecutePlanGoal published = planOf(1);
  publisher_.publish(published.plan);
  const ExecutePlanGoal sent = planOf(1);
  EXPECT_EQ(run(sent).outcome, ExecutePlanResult::SUCCESS);
  ASSERT_TRUE(succeeded(sent, 0));
  for (const ActionDispatch& dispatch : dispatches_.all()) {
    EXPECT_NE(dispatch.plan_id, published.plan.plan_id);
  }
}

TEST_F(Executor, staysTheOnlyOneInItsNamespace) {
  const TemporaryFolder folder;
  const std::string output = folder.path() + "/second";
  Program second(NODE_FOLDER "/plan_executor", {"__name:=second"}, {}, output);
  EXPECT_GT(second.exitStatus(), 0);
  EXPECT_NE(textOf(output).find("/simulated_executor offers /execute_plan already"),
            std::string::npos)
      << textOf(output);
  EXPECT_EQ(run(planOf(1)).outcome, ExecutePlanResult::SUCCESS);
}

TEST_F(Executor, isReplacedWhereAnEarlierOneWasKilled) {
  const TemporaryFolder folder;
  const Topic<actionlib_msgs::GoalStatusArray> status(node_, "/other/execute_plan/status");
  const auto start = [&](const std::string& name) {
    return std::make_unique<Program>(
        NODE_FOLDER "/plan_executor", std::vector<std::string>{"__ns:=/other", "__name:=" + name},
        std::map<std::string, std::string>{}, folder.path() + "/" + name);
  };
  auto first = start("first");
  ASSERT_TRUE(eventually([] { return offersOther("/other/first"); }));
  first->signal(SIGKILL);  // the master still knows it
  ASSERT_NE(first->exitStatus(), -1);
  const auto second = start("second");
  EXPECT_TRUE(eventually([] { return offersOther("/other/second"); }))
      << textOf(folder.path() + "/second");
}

TEST_F(Executor, tellsDiagnosticsOfItsPlans) {
  Topic<diagnostic_msgs::DiagnosticArray> topic(node_, "/diagnostics");
  ros::param::set("/simulated_executor/failing_step", 0);
  EXPECT_EQ(run(planOf(1)).outcome, ExecutePlanResult::STEP_FAILED);
  EXPECT_TRUE(topic.waitFor([](const diagnostic_msgs::DiagnosticArray& shown) {
    return std::any_of(shown.status.begin(), shown.status.end(), [](const auto& status) {
      return status.name == "simulated_executor: execution" &&
             status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
             status.message == "the last plan failed";
    });
  }));
}

}  // namespace
}  // namespace goal_alignment::test
