// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/alignment/robot_analysis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

namespace goal_alignment::alignment {
namespace {

Problem desk(std::vector<GroundName> plan) {
  return makeProblem(samples::deskRobot(), samples::deskHuman(), {}, std::move(plan));
}

TEST(RobotAnalysis, TellsWhereTheHumanPlanBreaks) {
  const Problem problem = desk(samples::deskPlan());
  const RobotAnalysis side = analyseRobot(problem, true, {}, {});
  EXPECT_FALSE(side.human_plan_runs);
  EXPECT_NE(side.human_plan_violation->message.find("(take B)"), std::string::npos);
  EXPECT_NE(side.human_plan_violation->message.find("(free)"), std::string::npos);
  EXPECT_EQ(side.achievability->candidateCount(), problem.candidates.size());
}

TEST(RobotAnalysis, APlanThatRunsHasNoViolation) {
  const RobotAnalysis side = analyseRobot(desk({{"take", {"a"}}, {"put", {"a"}}}), true, {}, {});
  EXPECT_TRUE(side.human_plan_runs);
  EXPECT_FALSE(side.human_plan_violation.has_value());
}

// Stage 0: what the plan reaches on the robot's side is known without a search.
TEST(RobotAnalysis, RemembersWhatTheHumanPlanAchieves) {
  const Problem problem = desk(samples::deskPlan());
  const RobotAnalysis side = analyseRobot(problem, true, {}, {});
  achievability::CandidateSet held_a(problem.candidates.size());
  held_a.set(3);
  EXPECT_EQ(problem.candidates[3].fluent.text(), "(held a)");
  const achievability::Check check = side.achievability->check(held_a, {});
  EXPECT_EQ(check.verdict, achievability::Verdict::Achievable);
  EXPECT_EQ(side.achievability->plannerCalls(), 0U);
}

RC_GTEST_PROP(RobotAnalysis, RunsThePlanAsTheValidatorDoes, ()) {
  RandomSource random = oracles::anySource();
  const oracles::Hagl hagl = oracles::randomHagl(random);
  const Problem problem =
      makeProblem(hagl.robot, hagl.human, hagl.input.goal, hagl.input.human_plan);
  const RobotAnalysis side = analyseRobot(problem, true, {}, {});
  const validation::Execution execution = validation::execute(hagl.robot, hagl.input.human_plan);
  RC_ASSERT(side.human_plan_runs == !execution.violation.has_value());
  if (execution.violation)
    RC_ASSERT(side.human_plan_violation->message == execution.violation->message);
}

TEST(RobotAnalysis, StopsWhenCancelled) {
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(analyseRobot(desk({}), true, {}, limits), LimitReached);
}

}  // namespace
}  // namespace goal_alignment::alignment
