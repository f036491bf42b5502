// SPDX-License-Identifier: BSD-3-Clause
// An aligner that is started anew while a plan is carried out is told what the steps have changed.
#include "aligner_calls.h"
#include "own_aligner.h"
#include "plan_runs.h"

namespace goal_alignment::test {
namespace {

class Restart : public OwnAligner, protected PlanRuns {
 protected:
  Restart() : PlanRuns(ros::NodeHandle{}) {}

  void SetUp() override {
    OwnAligner::SetUp();
    ros::param::set("/plan_executor/facts_timeout", 0.3);
  }

  /// With models from the parameters, so that the task begins where the robot is.
  AlignResult overTheLawn() {
    AlignGoal goal;
    goal.source = AlignGoal::PARAMS;
    goal.task.goal = {fluent("delivered", {})};
    goal.task.plan = {step("fetch", {"hall"}), step("cross", {"hall", "study"}),
                      step("deliver", {"study"})};
    align_.sendGoal(goal);
    return Scenario::awaitResult();
  }

  const Parameter robot_domain_{"robot_domain", model("errand_robot_domain.pddl")};
  const Parameter robot_problem_{"robot_problem", model("errand.pddl")};
  const Parameter human_domain_{"human_domain", model("errand_robot_domain.pddl")};
  const Parameter human_problem_{"human_problem", model("errand.pddl")};
};

TEST_F(Restart, losesNothingThatThePlanHasChanged) {
  setMapping(R"yaml(
default: {kind: simulated, duration: 0}
actions: {cross: {kind: simulated, duration: 2}, deliver: {kind: simulated, duration: 4}}
)yaml");
  const AlignResult aligned = overTheLawn();
  ASSERT_EQ(aligned.outcome, AlignResult::SUCCESS) << aligned.message;
  send(aligned.plan);
  ASSERT_TRUE(dispatched(aligned.plan, 1));
  killAligner();
  ASSERT_TRUE(dispatched(aligned.plan, 2)) << "what crossing has changed could not be told";
  ASSERT_NO_FATAL_FAILURE(startAligner());
  const ExecutePlanResult result = PlanRuns::awaitEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_EQ(doneBy(result), "(fetch hall) (cross hall study) (deliver study)");
  EXPECT_TRUE(eventually([&] {
    overTheLawn();
    const auto texts = textsOf(getFacts().facts);
    const auto isSo = [&](const char* text) {
      return std::count(texts.begin(), texts.end(), text) > 0;
    };
    return isSo("(at study)") && isSo("(delivered)") && !isSo("(at hall)") &&
           !isSo("(letter-at hall)");
  }));
}

TEST_F(Restart, isNoticedAtTheEndOfThePlanToo) {
  setMapping(
      "default: {kind: simulated, duration: 0}\nactions: {deliver: {kind: simulated, duration: "
      "3}}");
  const AlignResult aligned = overTheLawn();
  ASSERT_EQ(aligned.outcome, AlignResult::SUCCESS) << aligned.message;
  send(aligned.plan);
  ASSERT_TRUE(dispatched(aligned.plan, 2));
  killAligner();
  EXPECT_EQ(PlanRuns::awaitEnd().outcome, ExecutePlanResult::SUCCESS)
      << PlanRuns::awaitEnd().reason;
  ASSERT_NO_FATAL_FAILURE(startAligner());
  EXPECT_TRUE(eventually([&] {
    overTheLawn();
    const auto texts = textsOf(getFacts().facts);
    return std::count(texts.begin(), texts.end(), "(delivered)") > 0 &&
           std::count(texts.begin(), texts.end(), "(at study)") > 0;
  }));
}

TEST_F(Restart, leavesNobodyToPlanAnew) {
  ros::Publisher component = node_.advertise<ActionFeedback>("/action_feedback", 10);
  ASSERT_TRUE(eventually([&] { return component.getNumSubscribers() > 1; })) << "it and we";
  setMapping(
      "default: {kind: simulated, duration: 0}\n"
      "actions: {deliver: {kind: dispatch, timeout: 0, server_timeout: 60}}");
  const AlignResult aligned = overTheLawn();
  ASSERT_EQ(aligned.outcome, AlignResult::SUCCESS) << aligned.message;
  send(aligned.plan);
  ASSERT_TRUE(dispatched(aligned.plan, 2));
  killAligner();
  ASSERT_NO_FATAL_FAILURE(startAligner());
  ActionFeedback failed;
  failed.plan_id = aligned.plan.plan_id;
  failed.action_id = 2;
  failed.status = ActionFeedback::ACTION_FAILED;
  component.publish(failed);
  const ExecutePlanResult result = PlanRuns::awaitEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::STEP_FAILED);
  EXPECT_EQ(doneBy(result), "(fetch hall) (cross hall study)");
  EXPECT_NE(result.reason.find("no new plan, since the aligner was started anew and has forgotten "
                               "the task"),
            std::string::npos)
      << result.reason;
}

}  // namespace
}  // namespace goal_alignment::test
