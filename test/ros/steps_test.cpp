// SPDX-License-Identifier: BSD-3-Clause
// plan_executor with servers, services and components of any type: fields are filled, time-outs,
// retries and cancels reach the step that runs.
#include <actionlib/server/action_server.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>

#include "goal_alignment/AskHuman.h"
#include "plan_runs.h"

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

class Steps : public testing::Test, protected PlanRuns {
 protected:
  Steps() : PlanRuns(ros::NodeHandle{}) {}

  void expectFailure(const ExecutePlanResult& result, int outcome, const std::string& reason) {
    EXPECT_EQ(execute_.getState(), State::ABORTED);
    EXPECT_EQ(result.outcome, outcome);
    EXPECT_EQ(result.failed_step, 0);
    EXPECT_NE(result.reason.find(reason), std::string::npos) << result.reason;
  }

  void cancelWhileItRuns(const Plan& plan, const std::function<bool()>& it_runs) {
    send(plan);
    ASSERT_TRUE(eventually(it_runs));
    execute_.cancelGoal();
    const ExecutePlanResult result = awaitEnd();
    EXPECT_EQ(execute_.getState(), State::PREEMPTED);
    EXPECT_EQ(result.outcome, ExecutePlanResult::CANCELED);
    EXPECT_EQ(result.failed_step, 0);
    EXPECT_NE(result.reason.find("stopped during step 0"), std::string::npos) << result.reason;
  }

  ros::NodeHandle node_;
};

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
  setMapping(std::string(kGo) + "    timeout: 0.5\n    server_patience: 20\n");
  // The server itself may be found late, which is part of the time.
  ASSERT_TRUE(eventually([&] {
    run(planOf({kGoToKitchen}));
    return base.cancels == kCancels;
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
  execute_.cancelGoal();
  const ExecutePlanResult result = awaitEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::CANCELED);
  EXPECT_EQ(doneBy(result), "(go hall kitchen)");
  EXPECT_EQ(result.failed_step, 1);
}

TEST_F(Steps, followAMappingWhoseTypeIsCorrected) {
  FakeBase base(node_);
  setMapping(
      "actions: {go: {kind: action, name: move_base, type: goal_alignment/ExecutePlan, "
      "server_patience: 0.5}}");
  expectFailure(run(planOf({kGoToKitchen})), ExecutePlanResult::STEP_FAILED,
                "nobody offers the action move_base");
  setMapping(std::string(kGo) + "    server_patience: 20\n");
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
  ros::param::set("/plan_executor/cancel_patience", 0.2);
  FakeBase base(node_);
  base.mood = FakeBase::Mood::IgnoreCancel;
  setMapping(kGo);
  cancelWhileItRuns(planOf({kGoToKitchen}), [&] { return base.goals().size() == 1; });
  EXPECT_NE(awaitEnd().reason.find("did not end when it was cancelled"), std::string::npos);
  ros::param::del("/plan_executor/cancel_patience");
}

TEST_F(Steps, areNotBegunWithoutAServer) {
  std::string mapping = kGo;
  mapping.replace(mapping.find("name: move_base"), 15, "name: nowhere");
  setMapping(mapping + "    server_patience: 0.2\n");
  expectFailure(run(planOf({kGoToKitchen})), ExecutePlanResult::STEP_FAILED,
                "nobody offers the action nowhere");
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
    server_patience: 1
)";

class OwnServer : public Steps {
 protected:
  void startServer(const std::string& seconds) {
    server_ = std::make_unique<Program>(
        NODE_FOLDER "/simulated_executor",
        std::vector<std::string>{"__ns:=/helper", "_step_duration:=" + seconds, "_watch:=false"},
        std::map<std::string, std::string>{}, folder_.path() + "/helper.txt");
    Topic<ActionDispatch>& heard = helper_;
    ASSERT_TRUE(eventually([&] { return heard.isHeard(); }));
  }

  Topic<ActionDispatch> helper_{node_, "/helper/action_dispatch"};
  std::unique_ptr<Program> server_;
  const Plan plan_ = planOf({{"work", {{"task", "wash"}, {"who", "ann"}}}});
};

TEST_F(OwnServer, isGivenNestedListsAndItsResultIsLookedAt) {
  startServer("0.0");
  std::string mapping = kDelegate;
  mapping.replace(mapping.find("server_patience: 1"), 18, "server_patience: 20");
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
  bool reached = false;
  ASSERT_TRUE(eventually([&] {
    send(plan_);
    reached = helper_.waitFor([](const ActionDispatch&) { return true; }, 2).has_value();
    return reached;
  }));
  server_->signal(SIGKILL);
  expectFailure(awaitEnd(), ExecutePlanResult::STEP_FAILED, "went away");
}

/// Services as robots have them.
class FakeServices {
 public:
  explicit FakeServices(ros::NodeHandle node)
      : door_(node.advertiseService("/door/front/open", &FakeServices::open, this)),
        slow_(node.advertiseService("/slow", &FakeServices::wait, this)),
        ask_(node.advertiseService("/ask", &FakeServices::ask, this)) {}
  // roscpp drops a service that is still answering.
  ~FakeServices() {
    released = true;
    slow_.shutdown();
    eventually([this] { return inside == 0; });
  }

  bool open(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
    ++calls;
    asked = request.data != 0;
    response.success = opens;
    response.message = "locked";
    return !throws;
  }
  bool wait(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& /*response*/) {
    ++inside;
    ++waiting;
    eventually([this] { return released.load(); }, 60);
    --inside;
    return true;
  }
  bool ask(AskHuman::Request& request, AskHuman::Response& response) {
    question = request.question.fluents.at(0).args.at(0);
    response.answered_by = "ann";
    return true;
  }

  std::atomic<int> calls{0};
  std::atomic<int> waiting{0};
  std::atomic<int> inside{0};
  std::atomic<bool> released{false};
  std::atomic<bool> asked{false};
  std::atomic<bool> opens{true};
  std::atomic<bool> throws{false};
  std::string question;

 private:
  ros::ServiceServer door_;
  ros::ServiceServer slow_;
  ros::ServiceServer ask_;
};

const char* const kServices = R"(
actions:
  open: {kind: service, name: "/door/{door}/open", type: std_srvs/SetBool, request: {data: true},
         success_field: success, server_patience: 0.3}
  wait: {kind: service, name: /slow, type: std_srvs/Trigger}
  hurry: {kind: service, name: /slow, type: std_srvs/Trigger, timeout: 0.5}
  ask: {kind: service, name: /ask, type: goal_alignment/AskHuman, success_field: {answered_by: "{who}"},
        request: {question: {fluents: [{name: on, args: ["{who}", b]}]}}}
)";

TEST_F(Steps, callServicesOfAnyType) {
  FakeServices services(node_);
  setMapping(kServices);
  const ExecutePlanResult result =
      run(planOf({{"open", {{"door", "front"}}}, {"ask", {{"who", "ann"}}}}));
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_TRUE(services.asked);
  EXPECT_EQ(services.question, "ann");
}

TEST_F(Steps, failWhereAServiceSaysSo) {
  FakeServices services(node_);
  setMapping(kServices);
  services.opens = false;
  const Plan plan = planOf({{"open", {{"door", "front"}}}});
  expectFailure(run(plan), ExecutePlanResult::STEP_FAILED,
                "/door/front/open answered with success false");
  services.throws = true;
  expectFailure(run(plan), ExecutePlanResult::STEP_FAILED, "the call of /door/front/open failed");
  expectFailure(run(planOf({{"open", {{"door", "back"}}}})), ExecutePlanResult::STEP_FAILED,
                "nobody offers the service /door/back/open");
}

TEST_F(Steps, abandonAServiceThatDoesNotAnswer) {
  FakeServices services(node_);
  setMapping(kServices);
  expectFailure(run(planOf({{"hurry", {}}})), ExecutePlanResult::STEP_TIMED_OUT,
                "took more than 0.5 s");
  const int before = services.waiting;
  cancelWhileItRuns(planOf({{"wait", {}}}), [&] { return services.waiting > before; });
  services.released = true;
}

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
  setMapping("default: {kind: dispatch, timeout: 0.5, retries: 3, server_patience: 20}");
  EXPECT_EQ(run(planOf({{"wash", {}}})).outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
  EXPECT_EQ(component.dispatched, 2) << "it was not done once more";
  ros::param::del("/plan_executor/cancel_patience");
}

TEST_F(Steps, dispatchedThatNobodyTakesUpFail) {
  setMapping("default: {kind: dispatch, server_patience: 0.3}");
  expectFailure(run(planOf({{"fly", {}}})), ExecutePlanResult::STEP_FAILED,
                "nobody takes up the dispatched action fly");
}

TEST_F(Steps, ofAPlanThatIsDisplacedAreCancelledBeforeTheNextBegins) {
  FakeBase base(node_);
  base.mood = FakeBase::Mood::Wait;
  setMapping(kGo);
  send(planOf({kGoToKitchen}));
  ASSERT_TRUE(eventually([&] { return base.goals().size() == 1; }));
  base.mood = FakeBase::Mood::Succeed;
  ExecuteClient other(node_, "/execute_plan", false);
  ASSERT_TRUE(eventually([&] { return other.isServerConnected(); }));
  ExecutePlanGoal goal;
  goal.plan = planOf({kGoToKitchen});
  other.sendGoal(goal);
  EXPECT_EQ(awaitEnd().outcome, ExecutePlanResult::CANCELED);
  EXPECT_EQ(awaitEnd().reason.find("displaced by a newer plan: stopped during step 0"), 0U)
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
  EXPECT_EQ(result.reason.find("nothing says how to carry out step 0 (dance)"), 0U)
      << result.reason;
  result = run(planOf({{"go", {{"from", "hall"}, {"to", "attic"}}}}));
  EXPECT_NE(result.reason.find("table 'pose' has no entry for 'attic'"), std::string::npos)
      << result.reason;
  setMapping(kServices);
  result = run(planOf({{"open", {{"door", "fire-door"}}}}));
  EXPECT_EQ(result.outcome, ExecutePlanResult::INVALID_PLAN);
  EXPECT_NE(result.reason.find(".yaml:3:31: '/door/fire-door/open' can't be a name in ROS"),
            std::string::npos)
      << result.reason;
}

TEST_F(Steps, areRefusedBeforeTheyBeginWhereTheirEndCouldNotBeTold) {
  FakeServices services(node_);
  setMapping(R"(
actions: {open: {kind: service, name: "/door/{door}/open", type: std_srvs/SetBool,
                 success_field: {success: perhaps}}}
)");
  ExecutePlanResult result = run(planOf({{"open", {{"door", "front"}}}}));
  EXPECT_EQ(result.outcome, ExecutePlanResult::INVALID_PLAN);
  EXPECT_NE(result.reason.find(".yaml:3:43: expected a bool, found 'perhaps'"), std::string::npos)
      << result.reason;
  EXPECT_EQ(services.calls, 0);
  setMapping("actions: {take: {kind: simulated, moves: [{frame: cup, parent: \"{where}\"}]}}");
  result = run(planOf({{"take", {{"what", "cup"}}}}));
  EXPECT_EQ(result.outcome, ExecutePlanResult::INVALID_PLAN);
  EXPECT_NE(result.reason.find("has no parameter 'where'"), std::string::npos) << result.reason;
}

TEST_F(Steps, simulatedMoveFramesSmoothly) {
  Topic<tf2_msgs::TFMessage> tf(node_, "/tf");
  setMapping(R"(
tables: {pose: {kitchen: [4, 0, 0]}}
actions:
  go: {kind: simulated, duration: 1, moves: [{frame: base_link, to: "{pose:to}"}]}
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
