// SPDX-License-Identifier: BSD-3-Clause
// Outcomes that need no answer: plans, proofs and refusals, and that the node serves on.
#include <std_msgs/String.h>

#include "aligner_calls.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;

class NoQuestionNeeded : public Scenario {};
class NoPlan : public Scenario {};
class BrokenInput : public Scenario {
 protected:
  // Expects the goal to be refused with the code, and the next one to be served.
  AlignResult expectRefused(const AlignGoal& goal, int outcome) {
    align_.sendGoal(goal);
    const AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, outcome) << result.message;
    const auto state = align_.getState();
    EXPECT_TRUE(state == State::REJECTED || state == State::ABORTED) << state.toString();
    EXPECT_FALSE(result.message.empty());
    expectServed();
    return result;
  }

  void expectServed() {
    align_.sendGoal(sweepSilently());
    EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
    EXPECT_EQ(align_.getState(), State::SUCCEEDED);
  }
};

TEST_F(NoQuestionNeeded, whereTheModelsAgree) {
  align_.sendGoal(sweepSilently());
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_EQ(result.questions, 0U);
  ASSERT_EQ(result.plan.steps.size(), 1U);
  for (const Question& question : questions_.all())
    EXPECT_EQ(question.question_id, 0U);
  EXPECT_EQ(result.plan.kept_unasked.size(), 2U) << "(room hall) and (quiet hall)";
}

TEST_F(NoQuestionNeeded, byTheTopicHumanTaskToo) {
  Topic<AlignActionResult> results(node_, "/goal_alignment/align/result");
  ros::Publisher tasks = node_.advertise<HumanTask>("/human_task", 1);
  ASSERT_TRUE(eventually([&] { return tasks.getNumSubscribers() > 0; }));
  HumanTask task;
  task.task_id = "by topic";
  task.plan = {step("sweep", {"hall"})};
  tasks.publish(task);
  const auto state = states_.waitFor([](const AlignmentState& shown) {
    return shown.phase == AlignmentState::DONE && shown.outcome == AlignResult::SUCCESS &&
           shown.task_id == "by topic";
  });
  EXPECT_TRUE(state) << "parameters name models that agree";
}

TEST_F(NoQuestionNeeded, whereTheGoalIsTrueAlready) {
  AlignGoal goal = sweepSilently();
  goal.task.goal = {fluent("Quiet", {"HALL"})};
  goal.task.plan.clear();
  align_.sendGoal(goal);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  EXPECT_TRUE(result.plan.steps.empty());
  EXPECT_GT(result.plan.plan_id, 0);
}

TEST_F(NoPlan, whereTheGoalItselfIsUnsolvable) {
  AlignGoal goal = sweepHall();
  goal.robot_domain = model("stuck_robot_domain.pddl");
  align_.sendGoal(goal);
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::GOAL_UNSOLVABLE) << result.message;
  EXPECT_EQ(result.message,
            "I can't do what you asked for: \"clean\" holds for hall. That is certain.");
  EXPECT_EQ(align_.getState(), State::ABORTED);
  EXPECT_EQ(result.plan.plan_id, 0);
  EXPECT_EQ(result.questions, 0U);
}

TEST_F(BrokenInput, pddlIsRefusedWithItsPlace) {
  AlignGoal goal = sweepHall();
  goal.robot_domain = model("broken_domain.pddl");
  const AlignResult result = expectRefused(goal, AlignResult::INVALID_MODEL);
  EXPECT_NE(result.message.find("broken_domain.pddl:6:"), std::string::npos) << result.message;
}

TEST_F(BrokenInput, textIsNamedByItsField) {
  AlignGoal goal = sweepHall();
  goal.source = AlignGoal::TEXT;
  goal.robot_domain = goal.human_domain = "(define (domain tidy))";
  goal.robot_problem = goal.human_problem = std::string("(define\0(problem", 16);
  const AlignResult result = expectRefused(goal, AlignResult::INVALID_MODEL);
  EXPECT_EQ(result.message.find("robot_problem:1:"), 0U) << result.message;
}

TEST_F(BrokenInput, missingFilesFoldersAndEmptyNamesAreRefused) {
  for (const std::string& file : {model("nowhere.pddl"), model(""), std::string()}) {
    AlignGoal goal = sweepHall();
    goal.human_problem = file;
    expectRefused(goal, AlignResult::INVALID_MODEL);
  }
}

TEST_F(BrokenInput, planAndGoalThatDoNotFitAreToldApart) {
  AlignGoal plan = sweepHall();
  plan.task.plan = {step("sweep", {"hall"}), step("sweep", {"cellar"})};
  EXPECT_EQ(expectRefused(plan, AlignResult::HUMAN_PLAN_INVALID).failing_step, 1);
  plan.task.plan = {step("fly", {})};
  EXPECT_EQ(expectRefused(plan, AlignResult::HUMAN_PLAN_INVALID).failing_step, 0);

  AlignGoal unknown = sweepHall();
  unknown.task.goal = {fluent("clean", {"cellar"})};
  expectRefused(unknown, AlignResult::INVALID_MODEL);

  AlignGoal unexpected = sweepHall();
  unexpected.task.plan.clear();
  expectRefused(unexpected, AlignResult::GOAL_NOT_EXPECTED);
}

TEST_F(BrokenInput, fieldsOutOfRangeAreRefused) {
  const auto broken = [](const std::function<void(AlignGoal&)>& breakIt) {
    AlignGoal goal = sweepHall();
    breakIt(goal);
    return goal;
  };
  for (const AlignGoal& goal : {broken([](AlignGoal& g) { g.source = 9; }),
                                broken([](AlignGoal& g) { g.unsure_policy = 4; }),
                                broken([](AlignGoal& g) { g.max_questions = -2; }),
                                broken([](AlignGoal& g) { g.time_limit = ros::Duration(-1); }),
                                broken([](AlignGoal& g) { g.continue_session = "nobody's"; }),
                                broken([](AlignGoal& g) { g.task.goal.resize(1); }),
                                broken([](AlignGoal& g) { g.task.plan[0].args = {"a b"}; })}) {
    expectRefused(goal, AlignResult::INVALID_MODEL);
  }
}

TEST_F(BrokenInput, parametersOutOfRangeAreNamed) {
  ros::param::set("/goal_alignment/beta", -3.0);
  align_.sendGoal(sweepSilently());
  const AlignResult result = awaitResult();
  ros::param::del("/goal_alignment/beta");
  EXPECT_EQ(result.outcome, AlignResult::INVALID_MODEL);
  EXPECT_NE(result.message.find("/goal_alignment/beta"), std::string::npos) << result.message;
  EXPECT_EQ(align_.getState(), State::REJECTED);
  expectServed();
}

TEST_F(BrokenInput, noQuestionAllowedEndsUndecided) {
  AlignGoal goal = sweepHall();
  goal.max_questions = 0;
  expectRefused(goal, AlignResult::QUESTION_LIMIT);
}

TEST_F(BrokenInput, validateNamesFaultsAndFindsNoneInGoodModels) {
  const auto faulty = validate("(define (domain d) (:predicates (p ?x))",
                               "(define (problem q) (:domain d) (:init) (:goal (p a)))");
  EXPECT_FALSE(faulty.valid);
  ASSERT_FALSE(faulty.errors.empty());
  EXPECT_EQ(faulty.errors[0].find("domain:1:"), 0U) << faulty.errors[0];

  const auto good =
      validate("(define (domain d) (:predicates (p ?x)))",
               "(define (problem q) (:domain d) (:objects a) (:init (p a)) (:goal (p a)))");
  EXPECT_TRUE(good.valid);
  EXPECT_TRUE(good.errors.empty());
}

}  // namespace
}  // namespace goal_alignment::test
