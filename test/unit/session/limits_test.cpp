// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "generators/dialogue_tasks.h"
#include "goal_alignment/session/session.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

/// Running out and being told to stop: never taken for a proof.
namespace goal_alignment::session {
namespace {

using oracles::Hagl;
using samples::atFirstQuestion;
using samples::code;
using samples::desk;
using samples::expectedCode;
using samples::honest;
using samples::literals;
using samples::options;
using samples::talk;
using samples::think;
using samples::wanting;

TEST(SessionLimits, ATinyTimeLimitEndsUndecided) {
  Options chosen;
  chosen.time_limit = 1e-9;
  Session session(chosen);
  session.begin(desk());
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(code(session), 53);
}

TEST(SessionLimits, ATinyMemoryLimitEndsUndecided) {
  Options chosen;
  chosen.memory_limit = 1;
  Session session(chosen);
  session.begin(desk());
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(code(session), 54);
}

// Whatever the limits, the outcome is the right one or none. Little memory leaves suspected
// conflicts behind; a clock may stop anything anywhere.
RC_GTEST_PROP(SessionLimits, NeverMakeAnOutcomeWrong, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  for (const char* policy : {"auto", "optimal", "ratio", "paper", "ask-all"}) {
    Options chosen =
        options(policy, oracles::chance(random, 0.5) ? ConflictMode::Full : ConflictMode::Lazy, 1);
    if (oracles::chance(random, 0.7)) {
      chosen.memory_limit = 1000 + random.below(300'000);
    } else {
      chosen.time_limit = 1e-6 + random.unit() * 5e-4;
    }
    Session session(chosen);
    session.begin(hagl.input);
    talk(session, honest(hagl));
    RC_LOG() << policy << ": " << session.outcome().message << "\n";
    if (code(session) != 53 && code(session) != 54) RC_ASSERT(code(session) == expectedCode(hagl));
    // Memory is no matter of time, nor time of memory.
    RC_ASSERT(code(session) != (chosen.time_limit > 1 ? 53 : 54));
  }
}

TEST(SessionLimits, ANewAllowanceComesWithANewAnswer) {
  Options chosen;
  chosen.time_limit = 3;
  Session session = atFirstQuestion(chosen);
  session.answerTimedOut("nobody");
  for (int i = 0; i < 3; ++i) {
    session.setRobotState({{"free", {}}, {"down", {"a"}}, {"down", {"b"}}});
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // waiting is no thinking
    think(session);
    EXPECT_NE(code(session), 53);
  }
}

TEST(SessionCancel, BeforeTheFirstStepEndsAtTheFirstStep) {
  Session session{Options{}};
  session.cancel();
  session.begin(desk());
  EXPECT_EQ(session.step(), State::Done);
  EXPECT_EQ(code(session), 50);
}

TEST(SessionCancel, InEveryPhaseEndsAtTheNextStep) {
  for (int steps = 1;; ++steps) {
    Session session{Options{}};
    session.begin(desk());
    for (int i = 0; i < steps && session.state() == State::Analysing; ++i)
      session.step();
    if (session.state() != State::Analysing) break;
    session.cancel();
    EXPECT_EQ(session.step(), State::Done) << steps;
    EXPECT_EQ(code(session), 50) << steps;
  }
}

TEST(SessionCancel, WhileAQuestionIsOpen) {
  Session session = atFirstQuestion();
  session.cancel();
  EXPECT_EQ(session.step(), State::Done);
  EXPECT_EQ(code(session), 50);
  EXPECT_FALSE(session.question().has_value());
}

TEST(SessionCancel, IsUsedUpByTheOutcomeItBrings) {
  Session session = atFirstQuestion();
  session.answer(literals({"(held b)"}), AnswerKind::No, "me");
  session.cancel();
  think(session);
  EXPECT_EQ(code(session), 50);
  session.answer(literals({"(held a)"}), AnswerKind::No, "me");
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(code(session), 1);
}

// A cancel that comes when all is done must not end what is taken up later.
TEST(SessionCancel, AfterTheOutcomeIsNoCancelOfWhatComesNext) {
  Session session = atFirstQuestion();
  talk(session, wanting({"(held a)"}));
  session.cancel();
  EXPECT_EQ(session.step(), State::Done);
  EXPECT_EQ(code(session), 1);
  EXPECT_TRUE(session.revise(literals({"(held b)"}), AnswerKind::Yes, "me").accepted);
  think(session);
  EXPECT_EQ(code(session), 52);
}

RC_GTEST_PROP(SessionCancel, AtAnyTimeSpoilsNothing, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(options(oracles::chance(random, 0.5) ? "auto" : "paper",
                          oracles::chance(random, 0.5) ? ConflictMode::Full : ConflictMode::Lazy,
                          random.below(100)));
  session.begin(hagl.input);
  // Past the first phases: before them there is no task that a later answer could belong to.
  session.step();
  session.step();
  for (int i = 0; i < 40 && session.state() != State::Done; ++i) {
    if (session.state() == State::AwaitingAnswer) {
      const Literal fluent = session.question()->fluents.front();
      session.answer({fluent}, honest(hagl)(fluent), "person");
    }
    if (oracles::chance(random, 0.2)) session.cancel();
    session.step();
  }
  if (session.state() == State::Done && code(session) != 50) {
    RC_ASSERT(code(session) == expectedCode(hagl));
    return;
  }
  // Going on with the state that it had leads to the right end.
  std::vector<GroundName> atoms;
  for (const GroundName& atom : oracles::initialAtoms(hagl.robot))
    atoms.push_back(atom);
  session.setRobotState(atoms);
  talk(session, honest(hagl));
  RC_ASSERT(code(session) == expectedCode(hagl));
}

TEST(SessionCancel, FromAnotherThreadEndsALongSearch) {
  Session session{Options{}};
  session.begin(benchmarks::swappedTiles(5));
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    session.cancel();
  });
  think(session);
  other.join();
  EXPECT_EQ(code(session), 50);
}

TEST(SessionLimits, TheTimeLimitEndsALongSearch) {
  Options chosen;
  chosen.time_limit = 0.3;
  Session session(chosen);
  session.begin(benchmarks::swappedTiles(5));
  think(session);
  EXPECT_EQ(code(session), 53);
}

/// The puzzle, of which the person believes besides that one tile is in two places: that can't be,
/// which is known at once; what else can't be had together nobody finds out in time.
Input tileInTwoPlaces() {
  Input input = benchmarks::swappedTiles(4);
  std::string& human = input.human_problem.text;
  human.insert(human.find("(at t3 c3)"), "(at t3 c8) ");
  return input;
}

TEST(SessionLimits, FindingAllConflictsLeavesTimeForQuestions) {
  Options chosen;
  chosen.time_limit = 4;
  chosen.belief.mode = alignment::BeliefMode::Flat;
  Session session(chosen);
  session.begin(tileInTwoPlaces());
  ASSERT_EQ(think(session), State::AwaitingAnswer) << session.outcome().message;
  EXPECT_TRUE(session.question()->bound_is_provisional);
  session.answerTimedOut("nobody is there");
  const std::string& message = session.outcome().message;
  EXPECT_EQ(code(session), 60);
  EXPECT_NE(message.find("finding all conflicts stopped: time"), std::string::npos) << message;
}

TEST(SessionLimits, TheMemoryLimitEndsALongSearch) {
  Options chosen = options("paper");
  chosen.memory_limit = 6'000'000;
  Session session(chosen);
  session.begin(benchmarks::swappedTiles(5));
  talk(session, [](const Literal& /*fluent*/) { return AnswerKind::Yes; });
  EXPECT_EQ(code(session), 54) << session.outcome().message;
}

}  // namespace
}  // namespace goal_alignment::session
