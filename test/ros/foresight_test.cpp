// SPDX-License-Identifier: BSD-3-Clause
// plan_executor with an aligner: plans that can't end well any more are left before they waste what
// is needed, and what steps have changed is told whatever the aligner is at.
#include <rosgraph_msgs/Log.h>

#include "aligner_calls.h"
#include "frames.h"
#include "graph.h"
#include "plan_runs.h"

namespace goal_alignment::test {
namespace {

constexpr int kNo = Answer::Request::NO;

// A baker with few eggs. Nobody wants the cake, but the person expects that there will be one.
constexpr const char* kDomain = R"((define (domain bakery)
  (:requirements :adl)
  (:predicates (at ?room) (eggs ?n) (less ?n ?m) (baked ?what) (none ?n) (shut ?room)
               (oven ?what ?room) (lid-on))
  (:action walk :parameters (?from ?to)
    :precondition (and (at ?from) (not (shut ?to)))
    :effect (and (at ?to) (not (at ?from))))
  (:action bake :parameters (?what ?room)
    :precondition (and (at ?room) (oven ?what ?room) (not (exists (?n) (and (eggs ?n) (none ?n)))))
    :effect (and (baked ?what)
                 (forall (?n ?m) (when (and (eggs ?n) (less ?m ?n))
                                       (and (not (eggs ?n)) (eggs ?m))))))))";
constexpr const char* kProblem = R"((define (problem p) (:domain bakery)
  (:objects parlour bakehouse cellar cake bread n0 n1 n2)
  (:init (at parlour) (eggs n2) (less n0 n1) (less n1 n2) (none n0)
         (oven cake parlour) (oven bread bakehouse))
  (:goal (baked bread))))";
constexpr const char* kBoth = "(bake cake parlour) (walk parlour bakehouse) (bake bread bakehouse)";

class Foresight : public Scenario, protected PlanRuns {
 protected:
  Foresight() : PlanRuns(ros::NodeHandle{}), log_(node_, "/rosout") {
    writeText(file("domain"), kDomain);
    writeText(file("problem"), kProblem);
  }

  void SetUp() override {
    Scenario::SetUp();
    ros::param::set("/plan_executor/robot_domain", file("domain"));
    ros::param::set("/plan_executor/robot_problem", file("problem"));
    ros::param::set("/plan_executor/facts_timeout", 0.3);
    setMapping("default: {kind: simulated, duration: 0}");
  }

  std::string file(const std::string& name) const { return folder_.path() + "/" + name; }

  AlignGoal bakeBread() const {
    AlignGoal goal;
    goal.source = AlignGoal::FILES;
    goal.robot_domain = goal.human_domain = file("domain");
    goal.robot_problem = goal.human_problem = file("problem");
    goal.task.goal = {fluent("baked", {"bread"})};
    goal.task.plan = {step("bake", {"cake", "parlour"}), step("walk", {"parlour", "bakehouse"}),
                      step("bake", {"bread", "bakehouse"})};
    goal.max_questions = -1;
    return goal;
  }

  Plan alignedPlan() {
    align_.sendGoal(bakeBread());
    const AlignResult result = Scenario::awaitResult();
    EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
    return result.plan;
  }

  static void expectFact(const std::string& text, bool holds) {
    const auto texts = textsOf(getFacts().facts);
    EXPECT_EQ(std::count(texts.begin(), texts.end(), text), holds ? 1 : 0) << text;
  }

  /// Not to be answered by a timing: the question comes, or the plan ends.
  ExecutePlanResult answerNoUntilTheEnd() {
    std::uint32_t answered = 0;
    EXPECT_TRUE(eventually([&] {
      const auto question = questions_.last();
      if (question && question->question_id > answered) {
        answered = question->question_id;
        answer(kNo, answered);
      }
      return execute_.getState().isDone();
    }));
    return PlanRuns::awaitEnd();
  }

  Topic<rosgraph_msgs::Log> log_;
};

TEST_F(Foresight, leavesOutWhatNobodyAskedForBeforeItWastesWhatIsNeeded) {
  const Plan plan = alignedPlan();
  ASSERT_EQ(plan.steps.size(), 3U);
  ASSERT_TRUE(setFacts({negated(fluent("eggs", {"n2"})), fluent("eggs", {"n1"})}).accepted);
  send(plan);
  const ExecutePlanResult result = answerNoUntilTheEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_EQ(doneBy(result), "(walk parlour bakehouse) (bake bread bakehouse)");
  EXPECT_EQ(result.replans, 1U);
  expectFact("(baked bread)", true);
  expectFact("(baked cake)", false);
}

TEST_F(Foresight, saysWhyThereIsNoOtherPlanBeforeAnythingIsDone) {
  const Plan plan = alignedPlan();
  ASSERT_TRUE(setFacts({fluent("shut", {"bakehouse"})}).accepted);
  send(plan);
  const ExecutePlanResult result = answerNoUntilTheEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::PRECONDITION_FALSE);
  EXPECT_EQ(result.failed_step, 1);
  EXPECT_EQ(doneBy(result), "");
  EXPECT_EQ(result.reason.find("stopped before step 1: step 2 (walk parlour bakehouse) can't begin "
                               "then: the precondition (not (shut bakehouse)) is false"),
            0U)
      << result.reason;
  EXPECT_NE(result.reason.find("there is no new plan"), std::string::npos) << result.reason;
}

TEST_F(Foresight, looksAgainWhenSomethingChangesOnTheWay) {
  setMapping(
      "actions: {bake: {kind: simulated, duration: 2}, walk: {kind: simulated, duration: 0}}");
  const Plan plan = alignedPlan();
  send(plan);
  ASSERT_TRUE(dispatched(plan, 0));
  ASSERT_TRUE(setFacts({negated(fluent("oven", {"bread", "bakehouse"})),
                        fluent("oven", {"bread", "cellar"})})
                  .accepted);
  const ExecutePlanResult result = answerNoUntilTheEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_EQ(result.replans, 1U);
  const std::string done = doneBy(result);
  EXPECT_EQ(done.find("(bake cake parlour)"), 0U) << done;
  EXPECT_EQ(done.find("(bake bread bakehouse)"), std::string::npos) << done;
  EXPECT_NE(done.find("(bake bread cellar)"), std::string::npos) << done;
}

TEST_F(Foresight, goesOnAndTellsWhatChangesWhileTheAlignerIsAtAnotherTask) {
  setMapping(
      "actions: {bake: {kind: simulated, duration: 2}, walk: {kind: simulated, duration: 0}}");
  const Plan plan = alignedPlan();
  send(plan);
  ASSERT_TRUE(dispatched(plan, 0));
  alignedPlan();
  const ExecutePlanResult result = PlanRuns::awaitEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  EXPECT_EQ(doneBy(result), kBoth);
  expectFact("(baked cake)", true);
  expectFact("(baked bread)", true);
  expectFact("(at bakehouse)", true);
  expectFact("(at parlour)", false);
  expectFact("(eggs n0)", true);
}

TEST_F(Foresight, getsNoNewPlanOfATaskThatTheAlignerHasLeft) {
  setMapping("default: {kind: simulated, duration: 2}\nfailures: {(bake bread bakehouse): always}");
  const Plan plan = alignedPlan();
  send(plan);
  ASSERT_TRUE(dispatched(plan, 0));
  alignedPlan();
  const ExecutePlanResult result = PlanRuns::awaitEnd();
  EXPECT_EQ(result.outcome, ExecutePlanResult::STEP_FAILED);
  EXPECT_NE(result.reason.find("the aligner is at another task by now"), std::string::npos)
      << result.reason;
  expectFact("(baked cake)", true);
}

TEST_F(Foresight, saysWhereTfContradictsAStep) {
  Frames frames;
  frames.place("baker_1", 1);
  writeText(file("rules.yaml"), R"(
frames: {baker: baker_1}
regions: {parlour: {box: {xyz: [0, 0, 0], size: [9, 9]}}}
rules:
  - {fact: (lid-on), when: baker in parlour, max_age: 60}
)");
  std::string domain = kDomain;
  domain.replace(domain.find("(and (at ?to)"), 13, "(and (not (lid-on)) (at ?to)");
  writeText(file("domain"), domain);
  const Parameter rules("tf_facts", file("rules.yaml"));
  const Parameter patience("tf_timeout", kPatience);
  ASSERT_TRUE(eventually([] { return reachesUs("/plan_executor", "/rosout"); }));
  const ExecutePlanResult result = run(alignedPlan());
  EXPECT_EQ(result.outcome, ExecutePlanResult::SUCCESS) << result.reason;
  const auto said = log_.waitFor([](const rosgraph_msgs::Log& line) {
    return line.msg.find("tf contradicts a step that succeeded") == 0;
  });
  ASSERT_TRUE(said);
  EXPECT_NE(
      said->msg.find("after (walk parlour bakehouse) it should be (not (lid-on)), but tf says "
                     "(lid-on), by the frame baker_1 ("),
      std::string::npos)
      << said->msg;
}

TEST_F(Foresight, doesNotTakeForDoneWhatTfDoesNotSee) {
  Frames frames;
  frames.place("baker_2", 1);
  writeText(file("rules.yaml"), R"(
frames: {baker: baker_2}
regions: {oven: {box: {xyz: [50, 0, 0], size: [9, 9]}}}
rules:
  - {fact: (baked bread), when: baker in oven, max_age: 60}
)");
  const Parameter rules("tf_facts", file("rules.yaml"));
  const Parameter patience("tf_timeout", kPatience);
  ros::param::set("/plan_executor/max_replans", 0);
  const ExecutePlanResult result = run(alignedPlan());
  ros::param::del("/plan_executor/max_replans");
  EXPECT_EQ(result.outcome, ExecutePlanResult::GOAL_NOT_REACHED);
  EXPECT_EQ(doneBy(result), kBoth);
  EXPECT_NE(result.reason.find("(baked bread) does not hold"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace goal_alignment::test
