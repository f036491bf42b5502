// SPDX-License-Identifier: BSD-3-Clause
// plan_executor with action servers of any type, and what all kinds of steps have in common: fields
// are filled, time-outs, retries and cancels reach the step that runs.
#include <actionlib/server/action_server.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>

#include "graph.h"
#include "steps.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;
constexpr int kCancels = 1;

/// A server as navigation has one, which ends its goals as it is told.
class FakeBase {
 public:
  using Server = actionlib::ActionServer<move_base_msgs::MoveBaseAction>;
  enum class Mood { Succeed, Abort, FailOnce, Wait, IgnoreCancel, SucceedWhenCancelled };

  explicit FakeBase(ros::NodeHandle node, const std::string& name = "move_base")
      : server_(
            node, name, [this](Server::GoalHandle goal) { take(goal); },
            [this](Server::GoalHandle goal) { cancel(goal); }, false) {
    server_.start();
  }

  void take(Server::GoalHandle goal) {
    goal.setAccepted();
    const std::lock_guard<std::mutex> lock(mutex_);
    goals_.push_back(*goal.getGoal());
    if (mood == Mood::Succeed || (mood == Mood::FailOnce && goals_.size() > 1)) {
      goal.setSucceeded();
    } else if (mood == Mood::Abort || mood == Mood::FailOnce) {
      goal.setAborted({}, "a chair is in the way");
    }
  }

  void cancel(Server::GoalHandle goal) {
    ++cancels;
    // One that came before its goal was taken up would not let it succeed.
    if (goal.getGoalStatus().status == actionlib_msgs::GoalStatus::RECALLING) goal.setAccepted();
    if (mood == Mood::SucceedWhenCancelled) {
      goal.setSucceeded();
    } else if (mood != Mood::IgnoreCancel) {
      goal.setCanceled();
    }
  }

  std::vector<move_base_msgs::MoveBaseGoal> goals() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return goals_;
  }

  std::atomic<Mood> mood{Mood::Succeed};
  std::atomic<int> cancels{0};

 private:
  std::mutex mutex_;
  std::vector<move_base_msgs::MoveBaseGoal> goals_;
  Server server_;
};

const char* const kGo = R"(
tables: {pose: {kitchen: {position: {x: 2, y: 3.5}, orientation: {w: 1}}}}
actions:
  go:
    kind: action
    name: move_base
    type: move_base_msgs/MoveBase
    goal: {target_pose: {header: {frame_id: "map_of_{from}"}, pose: "{pose:to}"}}
)";
const Step kGoToKitchen = {"go", {{"from", "hall"}, {"to", "kitchen"}}};

TEST_F(Steps, fillTheGoalOfAnActionServer) {
  FakeBase base(node_);
  setMapping(kGo);
  const ExecutePlanResult result = run(planOf({kGoToKitchen, kGoToKitchen}));
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_EQ(doneBy(result), "(go hall kitchen) (go hall kitchen)");
  ASSERT_EQ(base.goals().size(), 2U);
  const auto pose = base.goals()[0].target_pose;
  EXPECT_EQ(pose.header.frame_id, "map_of_hall");
  EXPECT_FALSE(pose.header.stamp.isZero());
  EXPECT_EQ(pose.pose.position.x, 2);
  EXPECT_EQ(pose.pose.position.y, 3.5);
  EXPECT_EQ(pose.pose.orientation.w, 1);
}

TEST_F(Steps, tellWhyAnActionServerGaveUp) {
  FakeBase base(node_);
  base.mood = FakeBase::Mood::Abort;
  setMapping(kGo);
  expectFailure(run(planOf({kGoToKitchen})), ExecutePlanResult::STEP_FAILED,
                "aborted the goal: a chair is in the way");
  EXPECT_EQ(base.goals().size(), 1U);
}

TEST_F(Steps, areTriedAgainAsOftenAsTheMappingSays) {
  FakeBase base(node_);
  base.mood = FakeBase::Mood::FailOnce;
  setMapping(std::string(kGo) + "    retries: 1\n");
  EXPECT_EQ(run(planOf({kGoToKitchen})).outcome, ExecutePlanResult::SUCCESS);
  EXPECT_EQ(base.goals().size(), 2U);
  base.mood = FakeBase::Mood::Abort;
  run(planOf({kGoToKitchen}));
  EXPECT_EQ(base.goals().size(), 4U);
}

TEST_F(Steps, ofAnActionServerAreCancelledAfterTheirTime) {
  FakeBase base(node_);
  base.mood = FakeBase::Mood::Wait;
  setMapping(std::string(kGo) + "    timeout: 0.5\n    server_timeout: 20\n");
  // The server itself may be found late, which is part of the time.
  ASSERT_TRUE(eventually([&] {
    run(planOf({kGoToKitchen}));
    return base.cancels >= kCancels;
  }));
  EXPECT_EQ(awaitEnd().outcome, ExecutePlanResult::STEP_TIMED_OUT);
  EXPECT_NE(awaitEnd().reason.find("took more than 0.5 s"), std::string::npos);
}

TEST_F(Steps, thatSucceedThoughTheyAreCancelledAreDone) {
  FakeBase base(node_);
  setMapping(kGo);
  ASSERT_EQ(run(planOf({kGoToKitchen})).outcome, ExecutePlanResult::SUCCESS) << "now it is found";
  base.mood = FakeBase::Mood::SucceedWhenCancelled;
  setMapping(std::string(kGo) + "    timeout: 0.5\n    retries: 3\n");
  EXPECT_EQ(run(planOf({kGoToKitchen})).outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
  EXPECT_EQ(base.goals().size(), 2U) << "it was not done once more";

  setMapping(kGo);
  send(planOf({kGoToKitchen, kGoToKitchen}));
  ASSERT_TRUE(eventually([&] { return base.goals().size() == 3; }));
  cancelKnownGoal(execute_);
  const ExecutePlanResult result = awaitEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::CANCELED);
  EXPECT_EQ(doneBy(result), "(go hall kitchen)");
  EXPECT_EQ(result.failed_step, 1);
}

TEST_F(Steps, followAMappingWhoseTypeIsCorrected) {
  FakeBase base(node_);
  setMapping(
      "actions: {go: {kind: action, name: move_base, type: goal_alignment/ExecutePlan, "
      "server_timeout: 0.5}}");
  expectFailure(run(planOf({kGoToKitchen})), ExecutePlanResult::STEP_FAILED,
                "nobody offers the action move_base");
  setMapping(std::string(kGo) + "    server_timeout: 20\n");
  EXPECT_EQ(run(planOf({kGoToKitchen})).outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
}

TEST_F(Steps, ofAnActionServerAreCancelledWithThePlan) {
  FakeBase base(node_);
  base.mood = FakeBase::Mood::Wait;
  setMapping(kGo);
  cancelWhileItRuns(planOf({kGoToKitchen}), [&] { return base.goals().size() == 1; });
  EXPECT_EQ(base.cancels, kCancels);
}

TEST_F(Steps, thatDoNotStopWhenCancelledAreLeft) {
  ros::param::set("/plan_executor/cancel_timeout", 0.2);
  FakeBase base(node_);
  base.mood = FakeBase::Mood::IgnoreCancel;
  setMapping(kGo);
  cancelWhileItRuns(planOf({kGoToKitchen}), [&] { return base.goals().size() == 1; });
  EXPECT_NE(awaitEnd().reason.find("did not end when it was canceled"), std::string::npos);
  ros::param::del("/plan_executor/cancel_timeout");
}

TEST_F(Steps, areNotBegunWithoutAServer) {
  std::string mapping = kGo;
  mapping.replace(mapping.find("name: move_base"), 15, "name: nowhere");
  setMapping(mapping + "    server_timeout: 0.2\n");
  expectFailure(run(planOf({kGoToKitchen})), ExecutePlanResult::STEP_FAILED,
                "nobody offers the action nowhere");
}

TEST_F(Steps, areNotBegunWhereALaterOneHasNoServer) {
  FakeBase base(node_);
  setMapping(std::string(kGo) + R"yaml(
  grasp: {kind: action, name: /move_bsae, type: move_base_msgs/MoveBase, server_timeout: 0.3,
          failure_facts: ["(not (has {what}))"]}
  open: {kind: service, name: /plan_executor/get_logers, type: std_srvs/Trigger, server_timeout: 0.3}
)yaml");
  const Plan plan = planOf({kGoToKitchen, {"grasp", {{"what", "cup"}}}, {"open", {}}});
  const ExecutePlanResult result = run(plan);
  EXPECT_EQ(result.outcome, ExecutePlanResult::STEP_FAILED);
  EXPECT_EQ(result.failed_step, 1);
  for (const char* part :
       {"step 2 (grasp cup) can't be carried out: nobody offers the action /move_bsae of type "
        "move_base_msgs/MoveBase; did you mean '/move_base'?",
        "nor can step 3 (open): nobody offers the service /plan_executor/get_logers; did you mean "
        "'/plan_executor/get_loggers'?",
        "no other plan is sought"}) {
    EXPECT_NE(result.reason.find(part), std::string::npos) << result.reason;
  }
  EXPECT_TRUE(base.goals().empty());
  for (const ActionDispatch& dispatch : dispatches_.all())
    EXPECT_NE(dispatch.plan_id, plan.plan_id) << "nothing was dispatched";
}

TEST_F(Steps, thatDoNotStopWhenCancelledAreNotTriedAgain) {
  ros::param::set("/plan_executor/cancel_timeout", 0.2);
  FakeBase base(node_);
  setMapping(kGo);
  ASSERT_EQ(run(planOf({kGoToKitchen})).outcome, ExecutePlanResult::SUCCESS) << "now it is found";
  base.mood = FakeBase::Mood::IgnoreCancel;
  setMapping(std::string(kGo) + "    timeout: 0.5\n    retries: 3\n");
  expectFailure(run(planOf({kGoToKitchen})), ExecutePlanResult::STEP_TIMED_OUT,
                "it is not tried again, since that try is not over");
  EXPECT_EQ(base.goals().size(), 2U);
  ros::param::del("/plan_executor/cancel_timeout");
}

// The server is a simulated_executor: its goal has lists of messages within messages.
const char* const kDelegate = R"(
actions:
  work:
    kind: action
    name: /helper/execute_plan
    type: goal_alignment/ExecutePlan
    goal: {plan: {plan_id: 7, steps: [{name: "{task}", plan_id: 7, parameters: [{key: who, value: "{who}"}]}]}}
    success_field: {outcome: 1, failed_step: -1}
    server_timeout: 1
)";

class OwnServer : public Steps {
 protected:
  void startServer(const std::string& seconds) {
    server_ = std::make_unique<Program>(
        NODE_FOLDER "/simulated_executor",
        std::vector<std::string>{"__ns:=/helper", "_step_duration:=" + seconds, "_watch:=false"},
        std::map<std::string, std::string>{}, folder_.path() + "/helper.txt");
    ASSERT_TRUE(eventually(
        [] { return reachesUs("/helper/simulated_executor", "/helper/action_dispatch"); }));
  }

  Topic<ActionDispatch> helper_{node_, "/helper/action_dispatch"};
  std::unique_ptr<Program> server_;
  const Plan plan_ = planOf({{"work", {{"task", "wash"}, {"who", "ann"}}}});
};

TEST_F(OwnServer, isGivenNestedListsAndItsResultIsLookedAt) {
  startServer("0.0");
  std::string mapping = kDelegate;
  mapping.replace(mapping.find("server_timeout: 1"), 18, "server_timeout: 20");
  setMapping(mapping);
  EXPECT_EQ(run(plan_).outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
  const auto step =
      helper_.waitFor([](const ActionDispatch& shown) { return shown.name == "wash"; });
  ASSERT_TRUE(step);
  ASSERT_EQ(step->parameters.size(), 1U);
  EXPECT_EQ(step->parameters[0].value, "ann");
  mapping.replace(mapping.find("outcome: 1"), 10, "outcome: 2");
  setMapping(mapping);
  expectFailure(run(plan_), ExecutePlanResult::STEP_FAILED, "answered with outcome 1");
}

TEST_F(OwnServer, isFoundToHaveDied) {
  startServer("3600.0");
  std::string mapping = kDelegate;
  setMapping(mapping + "    timeout: 0\n");
  // As soon as it can be reached.
  ASSERT_TRUE(eventually([&] {
    send(plan_);
    return eventually([&] { return helper_.last() || execute_.getState().isDone(); }) &&
           !execute_.getState().isDone();
  }));
  server_->signal(SIGKILL);
  expectFailure(awaitEnd(), ExecutePlanResult::STEP_FAILED, "went away");
}

TEST_F(Steps, ofAPlanThatIsDisplacedAreCancelledBeforeTheNextBegins) {
  FakeBase base(node_);
  base.mood = FakeBase::Mood::Wait;
  setMapping(kGo);
  send(planOf({kGoToKitchen}));
  ASSERT_TRUE(eventually([&] { return base.goals().size() == 1; }));
  base.mood = FakeBase::Mood::Succeed;
  ExecuteClient other(node_, "/execute_plan");
  ASSERT_TRUE(eventually([&] { return other.isServerConnected(); }));
  ExecutePlanGoal goal;
  goal.plan = planOf({kGoToKitchen});
  other.sendGoal(goal);
  EXPECT_EQ(awaitEnd().outcome, ExecutePlanResult::CANCELED);
  EXPECT_EQ(awaitEnd().reason.find("displaced by a newer plan: stopped during step 1"), 0U)
      << awaitEnd().reason;
  EXPECT_TRUE(eventually([&] { return other.getState().isDone(); }));
  EXPECT_EQ(other.getState(), State::SUCCEEDED);
  EXPECT_EQ(base.cancels, kCancels);
}

TEST_F(Steps, areRefusedWhereTheMappingIsFaultyOrSilent) {
  setMapping("actions:\n  go: {kind: fly}\n");
  ExecutePlanResult result = run(planOf({kGoToKitchen}));
  EXPECT_EQ(execute_.getState(), State::REJECTED);
  EXPECT_EQ(result.outcome, ExecutePlanResult::INVALID_PLAN);
  EXPECT_NE(result.reason.find(".yaml:2:14: expected one of action"), std::string::npos)
      << result.reason;
  setMapping(kGo);
  result = run(planOf({{"dance", {}}}));
  EXPECT_EQ(result.reason.find("nothing says how to carry out step 1 (dance)"), 0U)
      << result.reason;
  result = run(planOf({{"go", {{"from", "hall"}, {"to", "attic"}}}}));
  EXPECT_NE(result.reason.find("table 'pose' has no entry for 'attic'"), std::string::npos)
      << result.reason;
}

TEST_F(Steps, simulatedMoveFramesSmoothly) {
  Topic<tf2_msgs::TFMessage> tf(node_, "/tf");
  ASSERT_TRUE(eventually([&] { return tf.isHeard(); }));
  setMapping(R"(
tables: {pose: {kitchen: [4, 0, 0]}}
actions:
  go: {kind: simulated, duration: 3, moves: [{frame: base_link, to: "{pose:to}"}]}
  take: {kind: simulated, duration: 0, moves: [{frame: "{what}", parent: base_link, to: [0.5, 0, 1, 0]}]}
frames: {base_link: {parent: map}, cup: {parent: map, pose: [5, 0, 0]}}
)");
  const ExecutePlanResult result = run(planOf({kGoToKitchen, {"take", {{"what", "cup"}}}}));
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  const auto isShown = [&](const std::string& frame, const std::string& parent, double low,
                           double high) {
    return tf
        .waitFor([&](const tf2_msgs::TFMessage& message) {
          return std::any_of(message.transforms.begin(), message.transforms.end(),
                             [&](const auto& shown) {
                               const double x = shown.transform.translation.x;
                               return shown.child_frame_id == frame &&
                                      shown.header.frame_id == parent && x >= low && x <= high;
                             });
        })
        .has_value();
  };
  EXPECT_TRUE(isShown("base_link", "map", 0.01, 3.99)) << "on its way";
  EXPECT_TRUE(isShown("base_link", "map", 4, 4));
  EXPECT_TRUE(isShown("cup", "base_link", 0.5, 0.5));
}

}  // namespace
}  // namespace goal_alignment::test
