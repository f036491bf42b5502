// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/lifted_space.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

/// The robot's state has changed: the answers stay, everything about the robot is found out anew.
namespace goal_alignment::session {
namespace {

using oracles::Hagl;
using samples::atFirstQuestion;
using samples::code;
using samples::desk;
using samples::expectedCode;
using samples::honest;
using samples::literals;
using samples::talk;
using samples::think;
using samples::wanting;

std::vector<GroundName> names(const std::vector<std::string>& texts) {
  std::vector<GroundName> result;
  for (const std::string& text : texts)
    result.push_back(GroundName::parse(text));
  return result;
}

RC_GTEST_PROP(RobotState, ANewOneLeadsToTheOutcomeItMustHave, ()) {
  RandomSource random = oracles::anySource();
  Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(samples::options(
      oracles::chance(random, 0.5) ? "auto" : "paper",
      oracles::chance(random, 0.5) ? ConflictMode::Full : ConflictMode::Lazy, random.below(100)));
  session.begin(hagl.input);
  const auto states = oracles::LiftedSpace(hagl.robot, 10'000).states();
  std::set<Literal> asked;
  const auto ask = [&](const Literal& fluent) {
    RC_ASSERT(asked.insert(fluent).second);  // never twice, before or after
    return honest(hagl)(fluent);
  };
  // At a question or at the end.
  if (oracles::chance(random, 0.5)) {
    talk(session, ask);
  } else {
    think(session);
  }
  const std::size_t calls_before = session.statistics().planner_calls;
  const oracles::Atoms now = states[random.below(states.size())];
  session.setRobotState({now.begin(), now.end()});
  RC_ASSERT(session.state() == State::Analysing);
  hagl.robot.init.clear();
  for (const GroundName& atom : now)
    hagl.robot.init.push_back(hagl.robot.resolve(atom).value());
  hagl.analyse();
  talk(session, ask);
  RC_ASSERT(code(session) == expectedCode(hagl));
  RC_ASSERT(session.statistics().planner_calls >= calls_before);
  if (code(session) != 1) return;
  const std::vector<Literal> goal(hagl.true_goal.begin(), hagl.true_goal.end());
  RC_ASSERT(!validation::fault(hagl.robot, session.outcome().plan.steps, goal).has_value());
}

TEST(RobotState, WhatTheModelCannotHaveIsRefusedAndNothingChanges) {
  Session session = atFirstQuestion();
  for (const char* wrong : {"(fly a)", "(held z)", "(held)"}) {
    try {
      session.setRobotState(names({"(free)", wrong}));
      FAIL() << wrong;
    } catch (const pddl::SemanticError& error) {
      EXPECT_NE(std::string(error.what()).find(wrong), std::string::npos) << error.what();
    }
    EXPECT_EQ(session.state(), State::AwaitingAnswer);
    EXPECT_EQ(session.question()->fluents, literals({"(held b)"}));
  }
  talk(session, wanting({"(held a)"}));
  EXPECT_EQ(code(session), 1);
}

TEST(RobotState, KeepsWhatWasAnswered) {
  Session session = atFirstQuestion();
  talk(session, wanting({"(held a)"}));
  const std::size_t asked = session.questions().size();
  session.setRobotState(names({"(held a)", "(down b)", "(down c)", "(red a)"}));
  EXPECT_TRUE(talk(session, wanting({"(held a)"})).empty());
  EXPECT_EQ(session.questions().size(), asked);
  EXPECT_EQ(code(session), 1);
  EXPECT_TRUE(session.outcome().plan.steps.empty());  // it holds a already
}

TEST(RobotState, NeedsATask) {
  Session session{Options{}};
  EXPECT_THROW(session.setRobotState({}), std::logic_error);
}

// The answer may be on its way when the robot's state changes.
TEST(RobotState, ADontKnowThatEndsItWaitsForTheNewAnalysis) {
  Options abort;
  abort.unsure_policy = UnsurePolicy::Abort;
  Session session = samples::atFirstQuestion(abort);
  session.setRobotState(session.robotState());
  EXPECT_TRUE(session.answer(samples::literals({"(held b)"}), AnswerKind::Unsure, "me").accepted);
  EXPECT_EQ(samples::think(session), State::Done);
  EXPECT_EQ(samples::code(session), 64);
}

}  // namespace
}  // namespace goal_alignment::session
