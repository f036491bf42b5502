// SPDX-License-Identifier: BSD-3-Clause
// plan_executor with components as ROSPlan has them.
#include <atomic>

#include "steps.h"

namespace goal_alignment::test {
namespace {

/// A component as ROSPlan's are.
class FakeComponent {
 public:
  explicit FakeComponent(ros::NodeHandle node)
      : feedback_(node.advertise<ActionFeedback>("/action_feedback", 100)),
        dispatches_(node.subscribe("/action_dispatch", 100, &FakeComponent::hear, this)) {}

  bool isConnected() const {
    return feedback_.getNumSubscribers() > 1 && dispatches_.getNumPublishers() > 0;
  }

  void hear(const ActionDispatch::ConstPtr& dispatch) {
    if (dispatch->name == "cancel_action") {
      cancelled = dispatch->action_id;
      if (succeeds_when_cancelled)
        say(*dispatch, ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE, 0);
    }
    if (dispatch->name != "wash") return;
    ++dispatched;
    say(*dispatch, ActionFeedback::ACTION_ENABLED, 0);
    // Of others this is not to be believed.
    say(*dispatch, ActionFeedback::ACTION_FAILED, 5);
    // As ROSPlan's C++ base class does, which leaves the plan's id out.
    if (status >= 0) say(*dispatch, status, -dispatch->plan_id);
    // After its end nothing more is to be heard of it.
    if (status >= 0) say(*dispatch, ActionFeedback::ACTION_ENABLED, 0);
  }

  void say(const ActionDispatch& dispatch, int what, int other_plan) {
    ActionFeedback message;
    message.action_id = dispatch.action_id;
    message.plan_id = dispatch.plan_id + other_plan;
    message.status = what;
    feedback_.publish(message);
  }

  std::atomic<int> status{ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE};
  std::atomic<bool> succeeds_when_cancelled{false};
  std::atomic<int> dispatched{0};
  std::atomic<int> cancelled{-1};

 private:
  ros::Publisher feedback_;
  ros::Subscriber dispatches_;
};

TEST_F(Steps, dispatchedAreCarriedOutByOthers) {
  FakeComponent component(node_);
  ASSERT_TRUE(eventually([&] { return component.isConnected(); }));
  setMapping("default: {kind: dispatch, server_patience: 20}");
  const Plan plan = planOf({{"wash", {{"what", "cup"}}}, {"wash", {{"what", "pan"}}}});
  EXPECT_EQ(run(plan).outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
  EXPECT_EQ(component.dispatched, 2);
  component.status = ActionFeedback::ACTION_FAILED;
  expectFailure(run(planOf({{"wash", {}}})), ExecutePlanResult::STEP_FAILED,
                "the component of wash says that it failed");
  component.status = ActionFeedback::ACTION_PRECONDITION_FALSE;
  expectFailure(run(planOf({{"wash", {}}})), ExecutePlanResult::STEP_FAILED,
                "precondition is false");
}

TEST_F(Steps, dispatchedAreCancelledAsRosplanKnowsIt) {
  FakeComponent component(node_);
  ASSERT_TRUE(eventually([&] { return component.isConnected(); }));
  component.status = -1;
  ros::param::set("/plan_executor/cancel_patience", 0.1);
  setMapping("default: {kind: dispatch}");
  cancelWhileItRuns(planOf({{"wash", {}}}), [&] { return component.dispatched == 1; });
  EXPECT_TRUE(eventually([&] { return component.cancelled == 0; }));

  ros::param::set("/plan_executor/cancel_patience", 60.0);
  component.succeeds_when_cancelled = true;
  setMapping("default: {kind: dispatch, timeout: 3, retries: 3, server_patience: 20}");
  EXPECT_EQ(run(planOf({{"wash", {}}})).outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
  EXPECT_EQ(component.dispatched, 2) << "it was not done once more";
  ros::param::del("/plan_executor/cancel_patience");
}

TEST_F(Steps, dispatchedThatNobodyTakesUpFail) {
  setMapping("default: {kind: dispatch, server_patience: 0.3}");
  expectFailure(run(planOf({{"fly", {}}})), ExecutePlanResult::STEP_FAILED,
                "nobody takes up the dispatched action fly");
}

}  // namespace
}  // namespace goal_alignment::test
