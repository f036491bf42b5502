// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/alignment/problem.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

namespace goal_alignment::alignment {
namespace {

using goal_alignment::samples::deskHuman;
using goal_alignment::samples::deskRobot;
using oracles::Hagl;

Literal literal(const std::string& text) {
  return Literal::parse(text);
}

std::vector<Literal> fluents(const Problem& problem) {
  std::vector<Literal> result;
  for (const Candidate& candidate : problem.candidates)
    result.push_back(candidate.fluent);
  return result;
}

bool someActionTouches(const pddl::Model& model, const std::string& predicate) {
  const auto touches = [&](const pddl::LiftedAtom& atom) {
    return model.predicates.at(static_cast<std::size_t>(atom.predicate)).name.name == predicate;
  };
  return std::any_of(model.schemas.begin(), model.schemas.end(), [&](const pddl::Schema& schema) {
    return std::any_of(schema.add.begin(), schema.add.end(), touches) ||
           std::any_of(schema.del.begin(), schema.del.end(), touches);
  });
}

RC_GTEST_PROP(Problem, CandidatesAreTheExpectedStateWithoutTheSpecifiedGoal, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const Problem problem =
      makeProblem(hagl.robot, hagl.human, hagl.input.goal, hagl.input.human_plan);
  RC_ASSERT(problem.specified == hagl.specified);
  RC_ASSERT(fluents(problem) == hagl.candidates);
  for (const Candidate& candidate : problem.candidates) {
    const std::string& predicate = candidate.fluent.atom.name;
    RC_ASSERT(candidate.is_static == (!someActionTouches(hagl.robot, predicate) &&
                                      !someActionTouches(hagl.human, predicate)));
  }
}

TEST(Problem, TheGoalsOfTheFilesMayBeWrittenInAnyOrder) {
  pddl::Model human = deskHuman();
  human.setGoal({literal("(red a)"), literal("(down b)")});
  pddl::Model robot = deskRobot();
  robot.setGoal({literal("(down b)"), literal("(red a)"), literal("(down b)")});
  const Problem problem = makeProblem(robot, human, {}, samples::deskPlan());
  EXPECT_EQ(problem.specified, (std::vector<Literal>{literal("(down b)"), literal("(red a)")}));
}

TEST(Problem, DifferingGoalsAreRefusedWithBoth) {
  pddl::Model human = deskHuman();
  human.setGoal({literal("(free)")});
  try {
    makeProblem(deskRobot(), human, {}, samples::deskPlan());
    FAIL() << "two goals were taken for one";
  } catch (const GoalsDiffer& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("(down b)"), std::string::npos) << what;
    EXPECT_NE(what.find("(free)"), std::string::npos) << what;
  }
}

TEST(Problem, AGivenGoalReplacesThoseOfTheFiles) {
  pddl::Model human = deskHuman();
  human.setGoal({literal("(free)")});
  const Problem problem =
      makeProblem(deskRobot(), human, {literal("(held a)")}, samples::deskPlan());
  EXPECT_EQ(problem.specified, std::vector<Literal>{literal("(held a)")});
}

pddl::Model deskWithGoal(const std::string& domain, const std::string& goal) {
  std::string problem = samples::kDeskProblem;
  const std::string old = "(:goal (down b))";
  problem.replace(problem.find(old), old.size(), "(:goal " + goal + ")");
  return pddl::readModel({"d.pddl", domain}, {"p.pddl", problem});
}

Problem deskProblem(const std::string& robot_goal, const std::string& human_goal) {
  return makeProblem(deskWithGoal(samples::kDeskRobotDomain, robot_goal),
                     deskWithGoal(samples::kDeskHumanDomain, human_goal), {}, samples::deskPlan());
}

TEST(Problem, AGoalThatIsNoConjunctionIsKeptAsOneCondition) {
  const Problem problem = deskProblem("(and (down b) (or (red a) (red b)))",
                                      "(and (imply (not (RED B)) (red A)) (down B))");
  EXPECT_EQ(problem.specified, std::vector<Literal>{literal("(down b)")});
  EXPECT_EQ(problem.condition, "(or (red a) (red b))");
  EXPECT_EQ(problem.candidates.size(), 6U) << "(red a) is one of them";
}

TEST(Problem, GoalsThatDifferInTheConditionDiffer) {
  try {
    deskProblem("(or (red a) (free))", "(or (red a) (red b))");
    FAIL() << "two goals were taken for one";
  } catch (const GoalsDiffer& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("(or (free) (red a))"), std::string::npos) << what;
    EXPECT_NE(what.find("(or (red a) (red b))"), std::string::npos) << what;
  }
}

TEST(Problem, AConditionThatThePlanMissesIsNamed) {
  try {
    deskProblem("(forall (?x) (red ?x))", "(forall (?x) (red ?x))");
    FAIL() << "b is not red";
  } catch (const GoalNotExpected& error) {
    EXPECT_TRUE(error.missing().empty());
    EXPECT_NE(std::string(error.what()).find("(forall (?1 - object) (red ?1))"), std::string::npos)
        << error.what();
  }
}

TEST(Problem, AGivenGoalReplacesConditionsToo) {
  const Problem problem =
      makeProblem(deskWithGoal(samples::kDeskRobotDomain, "(or (red a) (free))"),
                  deskWithGoal(samples::kDeskHumanDomain, "(forall (?x) (red ?x))"),
                  {literal("(held a)")}, samples::deskPlan());
  EXPECT_EQ(problem.condition, "");
  EXPECT_TRUE(problem.robot.goal_condition.trivial());
}

TEST(Problem, AGivenGoalThatTheHumanModelCannotNameIsRefused) {
  try {
    makeProblem(deskRobot(), deskHuman(), {literal("(held z)")}, samples::deskPlan());
    FAIL() << "(held z) has no meaning";
  } catch (const pddl::SemanticError& error) {
    EXPECT_NE(std::string(error.what()).find("(held z)"), std::string::npos) << error.what();
  }
}

TEST(Problem, ANegatedGoalIsNoCandidateAndCountsInTheExpectedState) {
  const Problem problem =
      makeProblem(deskRobot(), deskHuman(), {literal("(not (held c))")}, samples::deskPlan());
  EXPECT_EQ(problem.candidates.size(), 7U);
  EXPECT_THROW(
      makeProblem(deskRobot(), deskHuman(), {literal("(not (held a))")}, samples::deskPlan()),
      GoalNotExpected);
}

TEST(Problem, AStepThatCannotBeTakenIsNamedWithItsPrecondition) {
  try {
    makeProblem(deskRobot(), deskHuman(), {}, {{"take", {"a"}}, {"put", {"b"}}, {"take", {"b"}}});
    FAIL() << "nobody holds b";
  } catch (const HumanPlanInvalid& error) {
    EXPECT_EQ(error.step(), 1U);
    const std::string what = error.what();
    EXPECT_NE(what.find("(put B)"), std::string::npos) << what;
    EXPECT_NE(what.find("(held B)"), std::string::npos) << what;
  }
}

TEST(Problem, AGoalThatThePlanMissesIsNamed) {
  try {
    makeProblem(deskRobot(), deskHuman(), {literal("(held c)"), literal("(free)")},
                samples::deskPlan());
    FAIL() << "the plan does not take c";
  } catch (const GoalNotExpected& error) {
    EXPECT_EQ(error.missing(), std::vector<Literal>{literal("(held c)")});
    EXPECT_NE(std::string(error.what()).find("(held c)"), std::string::npos) << error.what();
  }
}

TEST(Problem, WithoutAPlanTheExpectedStateIsTheBelievedInitialOne) {
  const Problem problem = makeProblem(deskRobot(), deskHuman(), {}, {});
  EXPECT_EQ(problem.candidates.size(), 4U);
  try {
    makeProblem(deskRobot(), deskHuman(), {literal("(held a)")}, {});
    FAIL() << "nobody holds a at first";
  } catch (const GoalNotExpected& error) {
    EXPECT_NE(std::string(error.what()).find("no plan given"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace goal_alignment::alignment
