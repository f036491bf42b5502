// SPDX-License-Identifier: BSD-3-Clause
// plan_executor with services of any type.
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>

#include "goal_alignment/AskHuman.h"
#include "steps.h"

namespace goal_alignment::test {
namespace {

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
         success_field: success, server_timeout: 0.3}
  wait: {kind: service, name: /slow, type: std_srvs/Trigger}
  hurry: {kind: service, name: /slow, type: std_srvs/Trigger, timeout: 0.5, retries: 2}
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
  ros::param::set("/plan_executor/cancel_timeout", 0.2);
  expectFailure(run(planOf({{"hurry", {}}})), ExecutePlanResult::STEP_TIMED_OUT,
                "it is not tried again, since that try is not over");
  EXPECT_EQ(services.waiting, 1);
  ros::param::del("/plan_executor/cancel_timeout");
  const Plan plan = planOf({{"wait", {}}});
  cancelWhileItRuns(plan, [&] { return dispatched(plan, 0); });
  services.released = true;
}

TEST_F(Steps, believeAServiceThatAnswersBeforeItWouldBeTriedAgain) {
  FakeServices services(node_);
  setMapping(kServices);
  ros::param::set("/plan_executor/cancel_timeout", 60.0);
  send(planOf({{"hurry", {}}}));
  ASSERT_TRUE(eventually([&] { return services.waiting == 1; }));
  ros::WallDuration(1).sleep();  // its time is over by then; if it is not, it succeeds all the same
  services.released = true;
  EXPECT_EQ(awaitEnd().outcome, ExecutePlanResult::SUCCESS) << awaitEnd().reason;
  EXPECT_EQ(services.waiting, 1);
  ros::param::del("/plan_executor/cancel_timeout");
}

TEST_F(Steps, areRefusedWhereAServiceCanNotHaveItsName) {
  setMapping(kServices);
  const ExecutePlanResult result = run(planOf({{"open", {{"door", "fire-door"}}}}));
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

}  // namespace
}  // namespace goal_alignment::test
