// SPDX-License-Identifier: BSD-3-Clause
// plan_executor with components as ROSPlan has them.
#include <atomic>
#include <csignal>

#include "graph.h"
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
    if (dispatch->name != "wash") {
      // Once it is withdrawn it is done after all.
      if (is_slow) takeUp(*dispatch);
      return;
    }
    ++dispatched;
    if (is_slow) return;
    // Only now the try before has come to its end.
    if (is_late && dispatched == 2)
      return say(*dispatch, ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE, 0);
    takeUp(*dispatch);
  }

  void takeUp(const ActionDispatch& taken) {
    const ActionDispatch* const dispatch = &taken;
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
  std::atomic<bool> is_late{false};
  std::atomic<bool> is_slow{false};
  std::atomic<int> dispatched{0};
  std::atomic<int> cancelled{-1};

 private:
  ros::Publisher feedback_;
  ros::Subscriber dispatches_;
};

TEST_F(Steps, dispatchedAreCarriedOutByOthers) {
  FakeComponent component(node_);
  ASSERT_TRUE(eventually([&] { return component.isConnected(); }));
  setMapping("default: {kind: dispatch, server_timeout: 20}");
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
  ros::param::set("/plan_executor/cancel_timeout", 0.1);
  setMapping("default: {kind: dispatch}");
  cancelWhileItRuns(planOf({{"wash", {}}}), [&] { return component.dispatched == 1; });
  EXPECT_TRUE(eventually([&] { return component.cancelled == 0; }));

  ros::param::set("/plan_executor/cancel_timeout", 60.0);
  component.succeeds_when_cancelled = true;
  setMapping("default: {kind: dispatch, timeout: 3, retries: 3, server_timeout: 20}");
  EXPECT_EQ(run(planOf({{"wash", {}}})).outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
  EXPECT_EQ(component.dispatched, 2) << "it was not done once more";
  ros::param::del("/plan_executor/cancel_timeout");
}

TEST_F(Steps, dispatchedThatNobodyTakesUpFail) {
  ros::param::set("/plan_executor/cancel_timeout", 0.2);
  setMapping("default: {kind: dispatch, server_timeout: 0.3}");
  expectFailure(run(planOf({{"fly", {}}})), ExecutePlanResult::STEP_FAILED,
                "nobody takes up the dispatched action fly");
  ros::param::del("/plan_executor/cancel_timeout");
}

// A component in a process of its own, which takes everything up and never ends.
const char* const kTireless = R"python(
import rospy
from goal_alignment.msg import ActionDispatch, ActionFeedback
rospy.init_node('tireless')
say = rospy.Publisher('/action_feedback', ActionFeedback, queue_size=10)
def hear(step):
    say.publish(ActionFeedback(action_id=step.action_id, plan_id=step.plan_id, status=1))
hearer = rospy.Subscriber('/action_dispatch', ActionDispatch, hear)
rospy.spin()
)python";

TEST_F(Steps, dispatchedOfWhichTheComponentDiesFailThoughOthersListen) {
  const Program component("/usr/bin/python3", {"-c", kTireless}, {}, folder_.path() + "/tireless");
  ASSERT_TRUE(eventually([] {
    return reaches("/tireless", "/plan_executor", "/action_dispatch") &&
           reaches("/plan_executor", "/tireless", "/action_feedback") &&
           reachesUs("/tireless", "/action_feedback");
  })) << textOf(folder_.path() + "/tireless");
  setMapping("default: {kind: dispatch, timeout: 0, server_timeout: 20}");
  const Plan plan = planOf({{"wash", {}}});
  send(plan);
  ASSERT_TRUE(feedback_.waitFor([&](const ActionFeedback& said) {
    return said.plan_id == plan.plan_id && said.status == ActionFeedback::ACTION_ENABLED;
  }));
  component.signal(SIGKILL);
  expectFailure(awaitEnd(), ExecutePlanResult::STEP_FAILED, "the component of wash is gone");
}

TEST_F(Steps, dispatchedTakeNoLateWordOfTheTryBeforeForTheirOwn) {
  FakeComponent component(node_);
  ASSERT_TRUE(eventually([&] { return component.isConnected(); }));
  component.status = -1;
  ros::param::set("/plan_executor/cancel_timeout", 0.1);
  setMapping("default: {kind: dispatch, timeout: 1, retries: 1, server_timeout: 20}");
  component.is_late = true;
  const ExecutePlanResult result = run(planOf({{"wash", {}}}));
  EXPECT_EQ(component.dispatched, 2);
  EXPECT_EQ(component.cancelled, 0) << "the first try was withdrawn";
  EXPECT_EQ(result.outcome, ExecutePlanResult::STEP_TIMED_OUT) << result.reason;
  ros::param::del("/plan_executor/cancel_timeout");
}

TEST_F(Steps, dispatchedThatAreTakenUpTooLateAreNotDoneTwice) {
  FakeComponent component(node_);
  ASSERT_TRUE(eventually([&] { return component.isConnected(); }));
  component.is_slow = true;
  setMapping("default: {kind: dispatch, retries: 3, server_timeout: 0.5}");
  ros::param::set("/plan_executor/cancel_timeout", 60.0);
  EXPECT_EQ(run(planOf({{"wash", {}}})).outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
  EXPECT_EQ(component.dispatched, 1);
  ros::param::del("/plan_executor/cancel_timeout");
}

TEST_F(Steps, dispatchedNameStatusesThatNobodyKnows) {
  FakeComponent component(node_);
  ASSERT_TRUE(eventually([&] { return component.isConnected(); }));
  component.status = 42;
  setMapping("default: {kind: dispatch, server_timeout: 20}");
  expectFailure(run(planOf({{"wash", {}}})), ExecutePlanResult::STEP_FAILED, "the status 42");
}

}  // namespace
}  // namespace goal_alignment::test
