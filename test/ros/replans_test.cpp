// SPDX-License-Identifier: BSD-3-Clause
// plan_executor with an aligner: preconditions are watched, failures and surprises lead to new
// plans under the same answers, and plans are executed on their own once.
#include <cstdint>
#include <set>

#include "aligner_calls.h"
#include "graph.h"
#include "plan_runs.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;
constexpr int kNo = Answer::Request::NO;
constexpr int kYes = Answer::Request::YES;
constexpr int kSeeds = 100;

/// Bring the letter to the study: see models/errand_robot_domain.pddl. Whether it is to be quiet
/// there is asked at first; whether the lawn matters, only when the corridor is blocked.
AlignGoal bringLetter() {
  AlignGoal goal = sweepHall();
  goal.robot_domain = model("errand_robot_domain.pddl");
  goal.human_domain = model("errand_human_domain.pddl");
  goal.robot_problem = goal.human_problem = model("errand.pddl");
  goal.task.plan = {step("fetch", {"hall"}), step("go", {"hall", "corridor"}),
                    step("go", {"corridor", "study"}), step("deliver", {"study"})};
  return goal;
}

/// The same for somebody who knows the robot and gives nothing for the lawn: nothing to ask.
AlignGoal overTheLawn() {
  AlignGoal goal = bringLetter();
  goal.human_domain = goal.robot_domain;
  goal.task.plan = {step("fetch", {"hall"}), step("cross", {"hall", "study"}),
                    step("deliver", {"study"})};
  return goal;
}

constexpr const char* kThroughTheCorridor =
    "(fetch hall) (go hall corridor) (go corridor study) (deliver study)";

const char* const kSimulated = R"yaml(
default: {kind: simulated, duration: 0}
actions:
  go: {failure_facts: ["(blocked {from} {to})"]}
)yaml";

class Replans : public Scenario, protected PlanRuns {
 protected:
  Replans() : PlanRuns(ros::NodeHandle{}) {}

  void SetUp() override {
    Scenario::SetUp();
    ros::param::set("/plan_executor/robot_domain", model("errand_robot_domain.pddl"));
    ros::param::set("/plan_executor/robot_problem", model("errand.pddl"));
    ros::param::set("/plan_executor/max_replans", 3);
    ros::param::set("/plan_executor/facts_timeout", 0.2);
  }

  /// The plan, after it was answered that quiet does not matter.
  Plan alignedPlan(std::uint8_t unsure_policy = AlignGoal::AS_YES) {
    AlignGoal goal = bringLetter();
    goal.unsure_policy = unsure_policy;
    const Question question = sendAndAwaitQuestion(goal);
    EXPECT_EQ(textsOf(question.fluents), std::vector<std::string>{"(quiet study)"});
    EXPECT_TRUE(answer(kNo, question.question_id).accepted);
    const AlignResult result = Scenario::awaitResult();
    EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
    EXPECT_EQ(result.plan.steps.size(), 4U);
    last_question_ = question.question_id;
    return result.plan;
  }

  std::string session() { return align_.getResult()->session_id; }

  void expectReason(const ExecutePlanResult& result, int outcome, const std::string& part) {
    EXPECT_EQ(result.outcome, outcome) << result.reason;
    EXPECT_NE(result.reason.find(part), std::string::npos) << result.reason;
  }

  /// What was asked since the plan was found.
  std::vector<std::string> askedSince() {
    std::vector<std::string> texts;
    std::set<std::uint32_t> ids;
    for (const Question& question : questions_.all()) {
      if (question.question_id > last_question_ && ids.insert(question.question_id).second)
        texts.push_back(textsOf(question.fluents).at(0));
    }
    return texts;
  }

  std::uint32_t last_question_ = 0;
};

TEST_F(Replans, areNotNeededWhereAllGoesWell) {
  setMapping(kSimulated);
  const ExecutePlanResult result = run(alignedPlan());
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_EQ(doneBy(result), kThroughTheCorridor);
  EXPECT_EQ(result.replans, 0U);
  const auto facts = callAligner<GetFacts>("get_facts").facts;
  const auto texts = textsOf(facts);
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "(at study)"), 1) << "the effects are told";
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "(at hall)"), 0);
}

TEST_F(Replans, goAnotherWayWithoutAskingAnythingTwice) {
  setMapping(std::string(kSimulated) + "failures: {(go corridor study): always}");
  send(alignedPlan());
  const Question lawn = awaitQuestionAfter(last_question_);
  EXPECT_EQ(textsOf(lawn.fluents), std::vector<std::string>{"(lawn-whole)"});
  EXPECT_TRUE(answer(kNo, lawn.question_id).accepted);
  const ExecutePlanResult result = PlanRuns::awaitEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_EQ(
      doneBy(result),
      "(fetch hall) (go hall corridor) (go corridor hall) (cross hall study) (deliver study)");
  EXPECT_EQ(result.replans, 1U);
  EXPECT_EQ(result.plan.steps.size(), 3U);
  EXPECT_EQ(askedSince(), std::vector<std::string>{"(lawn-whole)"});
}

TEST_F(Replans, stopWhereTheAnswersLeaveNoOtherPlan) {
  setMapping(std::string(kSimulated) + "failures: {(go hall corridor): always}");
  send(alignedPlan());
  const Question lawn = awaitQuestionAfter(last_question_);
  EXPECT_TRUE(answer(kYes, lawn.question_id).accepted);
  const ExecutePlanResult result = PlanRuns::awaitEnd();
  EXPECT_EQ(execute_.getState(), State::ABORTED);
  expectReason(result, ExecutePlanResult::STEP_FAILED, "there is no new plan (52)");
  EXPECT_EQ(result.failed_step, 1);
  EXPECT_EQ(doneBy(result), "(fetch hall)");
  EXPECT_EQ(result.plan.steps.size(), 4U) << "what was not carried out is in the result";
}

TEST_F(Replans, askUnderTheUnsurePolicyOfTheSession) {
  setMapping(std::string(kSimulated) + "failures: {(go hall corridor): always}");
  send(alignedPlan(AlignGoal::DEFER));
  for (int i = 0; i < 2; ++i) {  // DEFER asks once more
    const Question lawn = awaitQuestionAfter(last_question_);
    last_question_ = lawn.question_id;
    EXPECT_TRUE(answer(Answer::Request::UNSURE, lawn.question_id).accepted);
  }
  expectReason(PlanRuns::awaitEnd(), ExecutePlanResult::STEP_FAILED, "there is no new plan (64)");
}

TEST_F(Replans, areCancelledWithThePlan) {
  setMapping(std::string(kSimulated) + "failures: {(go hall corridor): always}");
  send(alignedPlan());
  awaitQuestionAfter(last_question_);
  cancelKnownGoal(execute_);
  const ExecutePlanResult result = PlanRuns::awaitEnd();
  EXPECT_EQ(execute_.getState(), State::PREEMPTED);
  expectReason(result, ExecutePlanResult::CANCELED, "stopped while a new plan was sought");
  EXPECT_TRUE(questionIsClosed());
}

TEST_F(Replans, followASurpriseBetweenTwoSteps) {
  setMapping(R"yaml(
default: {kind: simulated, duration: 0}
actions: {go: {kind: simulated, duration: 2}}
)yaml");
  const Plan plan = alignedPlan();
  send(plan);
  ASSERT_TRUE(dispatched(plan, 1));
  ASSERT_TRUE(
      setFacts({negated(fluent("has-letter", {})), fluent("letter-at", {"corridor"})}).accepted);
  const ExecutePlanResult result = PlanRuns::awaitEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_EQ(result.replans, 1U);
  EXPECT_EQ(doneBy(result),
            "(fetch hall) (go hall corridor) (fetch corridor) (go corridor study) (deliver study)");
  EXPECT_TRUE(feedback_.waitFor([&](const ActionFeedback& shown) {
    return shown.plan_id == plan.plan_id && shown.action_id == 3 &&
           shown.status == ActionFeedback::ACTION_PRECONDITION_FALSE;
  }));
  EXPECT_TRUE(askedSince().empty());
}

TEST_F(Replans, endWhenThereWereEnough) {
  setMapping("default: {kind: simulated, duration: 0}\nfailures: {(go hall corridor): always}");
  ros::param::set("/plan_executor/max_replans", 0);
  expectReason(run(alignedPlan()), ExecutePlanResult::STEP_FAILED, "(max_replans)");
}

TEST_F(Replans, endAtTheSecondFailureOfTheSameStep) {
  setMapping("default: {kind: simulated, duration: 0}\nfailures: {(go hall corridor): always}");
  const ExecutePlanResult result = run(alignedPlan());
  expectReason(result, ExecutePlanResult::STEP_FAILED,
               "(go hall corridor) failed, as it did before");
  EXPECT_EQ(result.replans, 1U);
}

TEST_F(Replans, areNotSoughtWhereTheMappingSaysStop) {
  setMapping(
      "default: {kind: simulated, duration: 0, on_failure: stop}\nfailures: {fetch hall: 1}");
  expectReason(run(alignedPlan()), ExecutePlanResult::STEP_FAILED, "no other plan is sought");
}

TEST_F(Replans, areNotSoughtForAPlanOfAnotherSession) {
  setMapping("default: {kind: simulated, duration: 0}\nfailures: {fetch hall: 1}");
  Plan plan = alignedPlan();
  plan.session_id = "another";
  expectReason(run(plan), ExecutePlanResult::STEP_FAILED, "the aligner is at another task by now");
}

TEST_F(Replans, endWithAReasonWhateverFailsAndAlikeForTheSameSeed) {
  setMapping(
      "default: {kind: simulated, duration: 0, failure_probability: 0.4}\n"
      "actions: {go: {failure_facts: [\"(blocked {from} {to})\"]}}");
  const AlignGoal goal = overTheLawn();
  const auto runWith = [&](int seed) {
    align_.sendGoal(goal);
    const AlignResult aligned = Scenario::awaitResult();
    EXPECT_EQ(aligned.outcome, AlignResult::SUCCESS) << aligned.message;
    ros::param::set("/plan_executor/seed", seed);
    return run(aligned.plan);
  };
  std::set<int> outcomes;
  unsigned replans = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const ExecutePlanResult result = runWith(seed);
    outcomes.insert(result.outcome);
    replans += result.replans;
    EXPECT_EQ(result.reason.empty(), result.outcome == ExecutePlanResult::SUCCESS);
    EXPECT_EQ(result.outcome == ExecutePlanResult::SUCCESS,
              execute_.getState() == State::SUCCEEDED);
    if (seed % 10 != 0) continue;
    const ExecutePlanResult again = runWith(seed);
    EXPECT_EQ(doneBy(again), doneBy(result));
    EXPECT_EQ(again.reason, result.reason);
    EXPECT_EQ(again.replans, result.replans);
  }
  EXPECT_EQ(outcomes.count(ExecutePlanResult::SUCCESS), 1U);
  EXPECT_EQ(outcomes.count(ExecutePlanResult::STEP_FAILED), 1U);
  EXPECT_EQ(outcomes.size(), 2U);
  EXPECT_GT(replans, 10U);
  ros::param::del("/plan_executor/seed");
}

/// An executor with auto_execute of the test's own, in a namespace.
class Automatic : public Replans {
 protected:
  Automatic()
      : auto_dispatches_(node_, "/own/action_dispatch"),
        auto_results_(node_, "/own/execute_plan/result") {}

  void startExecutor() {
    executor_ = std::make_unique<Program>(
        NODE_FOLDER "/simulated_executor",
        std::vector<std::string>{"__ns:=/own", "_aligner:=/goal_alignment", "_auto_execute:=true",
                                 "_step_duration:=0.0", "_mapping:=" + mapping_,
                                 "_robot_domain:=" + model("errand_robot_domain.pddl"),
                                 "_robot_problem:=" + model("errand.pddl")},
        std::map<std::string, std::string>{}, folder_.path() + "/own.txt");
    for (const char* topic : {"/own/action_dispatch", "/own/execute_plan/result"}) {
      ASSERT_TRUE(eventually([&] { return reachesUs("/own/simulated_executor", topic); }));
    }
  }

  /// Aligns until it is executed: the executor may hear the aligner a little later than we it.
  AlignResult alignUntilExecuted() {
    const AlignGoal goal = overTheLawn();
    AlignResult result;
    EXPECT_TRUE(eventually([&] {
      align_.sendGoal(goal);
      result = Scenario::awaitResult();
      return auto_dispatches_
          .waitFor([&](const ActionDispatch& d) { return d.plan_id == result.plan.plan_id; }, 2)
          .has_value();
    }));
    return result;
  }

  std::size_t runsOf(const Plan& plan) {
    const auto all = auto_dispatches_.all();
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const auto& shown) {
      return shown.plan_id == plan.plan_id && shown.action_id == 0;
    }));
  }

  std::string mapping_;
  Topic<ActionDispatch> auto_dispatches_;
  Topic<ExecutePlanActionResult> auto_results_;
  std::unique_ptr<Program> executor_;
};

TEST_F(Automatic, executesEachPlanOnce) {
  startExecutor();
  const AlignResult first = alignUntilExecuted();
  const AlignResult second = alignUntilExecuted();
  EXPECT_EQ(runsOf(first.plan), 1U);
  EXPECT_EQ(runsOf(second.plan), 1U);
}

TEST_F(Automatic, leavesAPlanOfAnEarlierLife) {
  startExecutor();
  const AlignResult old = alignUntilExecuted();
  ASSERT_EQ(runsOf(old.plan), 1U);
  executor_.reset();
  startExecutor();  // ~plan still shows the old plan
  const AlignResult fresh = alignUntilExecuted();
  EXPECT_EQ(runsOf(old.plan), 1U);
  EXPECT_EQ(runsOf(fresh.plan), 1U);
}

TEST_F(Automatic, doesNotTakeItsOwnNewPlanForAnother) {
  mapping_ = folder_.path() + "/own.yaml";
  writeText(mapping_, std::string(kSimulated) + "failures: {fetch hall: 1}\n");
  startExecutor();
  alignUntilExecuted();
  const auto end = auto_results_.waitFor(
      [](const ExecutePlanActionResult& shown) { return shown.result.replans == 1; });
  ASSERT_TRUE(end);
  EXPECT_EQ(end->result.outcome, ExecutePlanResult::SUCCESS) << end->result.reason;
  alignUntilExecuted();  // by then a second run of it would have begun
  EXPECT_EQ(runsOf(end->result.plan), 1U);
}

}  // namespace
}  // namespace goal_alignment::test
