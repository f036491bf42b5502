// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "goal_alignment/session/session.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

/// A dialogue that was aborted resumes where it was.
namespace goal_alignment::session {
namespace {

using oracles::Hagl;
using samples::atFirstQuestion;
using samples::code;
using samples::desk;
using samples::expectedCode;
using samples::honest;
using samples::literal;
using samples::options;
using samples::talk;
using samples::think;
using samples::wanting;

TEST(SessionResume, AfterACancelWithTheSameQuestion) {
  Session session = atFirstQuestion();
  const std::vector<Literal> asked = session.question()->fluents;
  session.cancel();
  session.step();
  ASSERT_EQ(code(session), 50);
  session.resume({});
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  EXPECT_EQ(session.question()->fluents, asked);
}

TEST(SessionResume, AndCountsAQuestionOncePerGoal) {
  Session session = atFirstQuestion();
  session.setRobotState(session.robotState());
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  EXPECT_EQ(session.snapshot().questions_asked, 1U) << "taken back and put again";
  EXPECT_EQ(session.question()->asked, 0U);
  session.answerTimedOut("nobody is there");
  EXPECT_EQ(session.snapshot().questions_asked, 1U);
  session.resume({});
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  EXPECT_EQ(session.snapshot().questions_asked, 2U);
}

TEST(SessionResume, AfterACancelBeforeTheModelsWereRead) {
  Session session{Options{}};
  session.begin(desk());
  session.cancel();
  session.step();
  ASSERT_EQ(code(session), 50);
  session.resume({});
  EXPECT_EQ(think(session), State::AwaitingAnswer);
}

TEST(SessionResume, AfterSilenceAndDecline) {
  Session session = atFirstQuestion();
  session.answerTimedOut("nobody is there");
  ASSERT_EQ(code(session), 60);
  session.resume({});
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  ASSERT_TRUE(session.answer({}, AnswerKind::Decline, "Ann").accepted);
  ASSERT_EQ(code(session), 61);
  session.resume({});
  EXPECT_EQ(think(session), State::AwaitingAnswer);
}

TEST(SessionResume, AfterTheWorldOutsideBrokeItOff) {
  Session session{Options{}};
  session.abort(OutcomeCode::StateUnknown, "where is it?");
  EXPECT_EQ(session.state(), State::Idle);
  session = atFirstQuestion();
  ASSERT_TRUE(session.answer({session.question()->fluents[0]}, AnswerKind::No, "me").accepted);
  think(session);
  const std::size_t asked = session.snapshot().questions_asked;
  for (const OutcomeCode why : {OutcomeCode::StateUnknown, OutcomeCode::InvalidModel}) {
    session.abort(why, "where is it?");
    EXPECT_EQ(session.state(), State::Done);
    EXPECT_EQ(session.outcome().code, why);
    EXPECT_EQ(session.outcome().message, "where is it?");
    session.resume({});
    EXPECT_EQ(session.state(), State::Analysing);
    think(session);
    EXPECT_NE(session.outcome().code, why);
  }
  EXPECT_GE(session.snapshot().questions_asked, asked) << "the answer is kept";
}

TEST(SessionResume, AfterTheQuestionLimitWithANewAllowance) {
  Options none;
  none.max_questions = 0;
  Session session(none);
  session.begin(desk());
  think(session);
  ASSERT_EQ(code(session), 62);
  Options one;
  one.max_questions = 1;
  session.resume(one);
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  const Literal fluent = session.question()->fluents.front();
  ASSERT_TRUE(session.answer({fluent}, AnswerKind::No, "Ann").accepted);
  if (think(session) == State::Done && code(session) != 62) return;  // one was enough
  ASSERT_EQ(code(session), 62);
  session.resume(one);
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  EXPECT_NE(session.question()->fluents.front(), fluent);
}

TEST(SessionResume, AfterATimeLimitWithANewOne) {
  Options tiny;
  tiny.time_limit = 1e-9;
  Session session(tiny);
  session.begin(desk());
  think(session);
  ASSERT_EQ(code(session), 53);
  session.resume({});
  EXPECT_EQ(think(session), State::AwaitingAnswer);
}

TEST(SessionResume, NotFromADefiniteOutcome) {
  Session session = atFirstQuestion();
  talk(session, wanting({}));
  ASSERT_EQ(code(session), 1);
  session.resume({});
  EXPECT_EQ(session.state(), State::Done);
  EXPECT_EQ(code(session), 1);
}

TEST(SessionResume, UnderAnUnsurePolicyThatDecides) {
  Options abort;
  abort.unsure_policy = UnsurePolicy::Abort;
  Session session = atFirstQuestion(abort);
  ASSERT_TRUE(session.answer(session.question()->fluents, AnswerKind::Unsure, "Ann").accepted);
  ASSERT_EQ(code(session), 64);
  session.resume({});
  EXPECT_NE(think(session), State::Idle);
  EXPECT_TRUE(session.state() == State::AwaitingAnswer || code(session) != 0);
}

Options under(UnsurePolicy policy) {
  Options options;
  options.unsure_policy = policy;
  return options;
}

// How often (held b), which blocks by itself, is asked about of somebody who never knows.
std::size_t timesAskedAboutHeldB(Session& session) {
  std::size_t times = 0;
  talk(session, [&](const Literal& fluent) {
    if (fluent != literal("(held b)")) return AnswerKind::No;
    ++times;
    return AnswerKind::Unsure;
  });
  EXPECT_EQ(code(session), 64);
  return times;
}

TEST(SessionResume, UnderItsOwnUnsurePolicy) {
  Session session = atFirstQuestion(under(UnsurePolicy::Defer));
  session.answerTimedOut("nobody is there");
  session.resume({});
  EXPECT_EQ(session.unsurePolicy(), UnsurePolicy::Defer);
  EXPECT_EQ(timesAskedAboutHeldB(session), 2U);
}

TEST(SessionResume, UnderTheUnsurePolicyThatItIsGiven) {
  Session session = atFirstQuestion(under(UnsurePolicy::Defer));
  session.answerTimedOut("nobody is there");
  session.resume(under(UnsurePolicy::AsYes));
  EXPECT_EQ(session.unsurePolicy(), UnsurePolicy::AsYes);
  EXPECT_EQ(timesAskedAboutHeldB(session), 1U);
}

TEST(SessionResume, UnderDeferAfterARevisedAnswer) {
  Session session = atFirstQuestion(under(UnsurePolicy::Defer));
  talk(session, wanting({}));
  ASSERT_EQ(code(session), 1);
  session.resume({});
  ASSERT_TRUE(session.revise({literal("(held b)")}, AnswerKind::Unsure, "Ann").accepted);
  EXPECT_EQ(timesAskedAboutHeldB(session), 1U) << "once more";
}

TEST(SessionResume, UnderAbortUntilTheNextDontKnow) {
  Session session = atFirstQuestion(under(UnsurePolicy::Abort));
  ASSERT_TRUE(session.answer(session.question()->fluents, AnswerKind::No, "Ann").accepted);
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  session.answerTimedOut("nobody is there");
  session.resume({});
  ASSERT_EQ(think(session), State::AwaitingAnswer);
  ASSERT_TRUE(session.answer(session.question()->fluents, AnswerKind::Unsure, "Ann").accepted);
  EXPECT_EQ(session.state(), State::Done);
  EXPECT_EQ(code(session), 64);
}

TEST(SessionResume, AnOptionOutOfRangeIsRefused) {
  Session session = atFirstQuestion();
  Options broken;
  broken.max_questions = -2;
  EXPECT_THROW(session.resume(broken), std::invalid_argument);
}

TEST(SessionAnswers, AreTakenAsSoonAsTheModelsAreRead) {
  Session session{Options{}};
  session.begin(desk());
  EXPECT_FALSE(session.answer({literal("(clear a)")}, AnswerKind::No, "Ann").accepted);
  EXPECT_EQ(session.robotModel(), nullptr);
  EXPECT_TRUE(session.robotState().empty());
  session.step();
  ASSERT_EQ(session.state(), State::Analysing);
  EXPECT_NE(session.robotModel(), nullptr);
  EXPECT_FALSE(session.robotState().empty());
  const auto candidates = session.snapshot().candidates;
  ASSERT_FALSE(candidates.empty());
  for (const CandidateView& candidate : candidates)
    EXPECT_TRUE(session.answer({candidate.fluent}, AnswerKind::No, "Ann").accepted);
  EXPECT_EQ(think(session), State::Done) << "nothing is left to ask";
  EXPECT_EQ(code(session), 1);
}

// Broken off anywhere and however often: the same outcome, and nothing is asked twice.
RC_GTEST_PROP(SessionResume, ToTheSameOutcomeAndAsksNothingTwice, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const auto mode = oracles::chance(random, 0.5) ? ConflictMode::Full : ConflictMode::Lazy;
  Session session(options(oracles::chance(random, 0.7) ? "auto" : "paper", mode, 1));
  session.begin(hagl.input);
  std::set<Literal> answered;
  const samples::Person person = honest(hagl);
  for (int steps = 0; session.state() != State::Done || code(session) == 50; ++steps) {
    RC_ASSERT(steps < 10'000);
    if (session.state() == State::Done) session.resume(options("auto", mode));
    if (oracles::chance(random, 0.3)) session.cancel();
    session.step();
    if (session.state() != State::AwaitingAnswer || oracles::chance(random, 0.2)) continue;
    const Literal fluent = session.question()->fluents.front();
    RC_ASSERT(answered.insert(fluent).second);
    RC_ASSERT(session.answer({fluent}, person(fluent), "person").accepted);
  }
  RC_ASSERT(code(session) == expectedCode(hagl));
}

}  // namespace
}  // namespace goal_alignment::session
