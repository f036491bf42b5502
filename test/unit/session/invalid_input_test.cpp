// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "goal_alignment/session/session.h"
#include "samples.h"

/// Input that can't be used is an outcome with a message, never an exception.
namespace goal_alignment::session {
namespace {

using samples::code;
using samples::desk;
using samples::literals;
using samples::think;

struct Ended {
  int code;
  std::string message;
  int failing_step;
};

Ended run(const Input& input) {
  Session session{Options{}};
  session.begin(input);
  EXPECT_EQ(think(session), State::Done);
  EXPECT_TRUE(session.outcome().plan.steps.empty());
  EXPECT_TRUE(session.questions().empty());
  return {code(session), session.outcome().message, session.outcome().failing_step};
}

void expectSays(const Ended& ended, const std::string& text) {
  EXPECT_NE(ended.message.find(text), std::string::npos) << ended.message;
}

TEST(InvalidInput, BrokenPddlIsNamedWithItsPlace) {
  for (pddl::Source Input::*file :
       {&Input::robot_domain, &Input::robot_problem, &Input::human_domain, &Input::human_problem}) {
    Input input = desk();
    (input.*file).text += ")";
    const Ended ended = run(input);
    EXPECT_EQ(ended.code, 70);
    expectSays(ended, (input.*file).name + ":");
  }
}

TEST(InvalidInput, AnEmptyInputIsBrokenPddl) {
  EXPECT_EQ(run({}).code, 70);
}

TEST(InvalidInput, GoalsThatDifferAreBothNamed) {
  Input input = desk();
  const std::size_t at = input.human_problem.text.find("(:goal (down b))");
  input.human_problem.text.replace(at, 16, "(:goal (down c))");
  const Ended ended = run(input);
  EXPECT_EQ(ended.code, 70);
  expectSays(ended, "(down b)");
  expectSays(ended, "(down c)");
}

TEST(InvalidInput, AGoalOutsideTheHumanModelIsNamed) {
  Input input = desk();
  input.goal = literals({"(fly a)"});
  const Ended ended = run(input);
  EXPECT_EQ(ended.code, 70);
  expectSays(ended, "(fly a)");
}

TEST(InvalidInput, APlanThatDoesNotRunIsNamedWithStepAndPrecondition) {
  Input input = desk();
  input.human_plan = {{"take", {"a"}}, {"put", {"c"}}};
  const Ended ended = run(input);
  EXPECT_EQ(ended.code, 71);
  EXPECT_EQ(ended.failing_step, 1);
  expectSays(ended, "(put C)");
  expectSays(ended, "(held C)");
}

TEST(InvalidInput, APlanWithAnUnknownActionIsNamed) {
  Input input = desk();
  input.human_plan = {{"teleport", {"a"}}};
  const Ended ended = run(input);
  EXPECT_EQ(ended.code, 71);
  EXPECT_EQ(ended.failing_step, 0);
  expectSays(ended, "teleport");
}

TEST(InvalidInput, AGoalThatIsNotExpectedIsNamed) {
  Input input = desk();
  input.goal = literals({"(held c)"});
  const Ended ended = run(input);
  EXPECT_EQ(ended.code, 72);
  expectSays(ended, "(held c)");
  EXPECT_EQ(ended.failing_step, -1);
}

TEST(InvalidInput, WithoutAPlanItSaysSo) {
  Input input = desk();
  input.goal = literals({"(held a)"});
  input.human_plan.clear();
  const Ended ended = run(input);
  EXPECT_EQ(ended.code, 72);
  expectSays(ended, "no plan given");
}

TEST(InvalidInput, TheNextTaskIsServed) {
  Session session{Options{}};
  session.begin({});
  think(session);
  session.begin(desk());
  EXPECT_EQ(think(session), State::AwaitingAnswer);
}

TEST(InvalidInput, AnswersAreRefused) {
  Session session{Options{}};
  session.begin({});
  think(session);
  const SubmitResult receipt = session.answer(literals({"(free)"}), AnswerKind::Yes, "me");
  EXPECT_FALSE(receipt.accepted);
  EXPECT_NE(receipt.message, "");
  EXPECT_EQ(session.state(), State::Done);
}

}  // namespace
}  // namespace goal_alignment::session
