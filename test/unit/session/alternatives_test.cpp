// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "analysed_desk.h"
#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"
#include "session/alternatives.h"

/// Where a dialogue ends without a plan there is something to choose.
namespace goal_alignment::session {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::anyOptions;
using samples::atFirstQuestion;
using samples::code;
using samples::honest;
using samples::literal;
using samples::literals;
using samples::options;
using samples::talk;
using samples::think;
using samples::wanting;

CandidateBits inState(const Hagl& hagl, const Session& session, CandidateState state) {
  std::vector<Literal> fluents;
  for (const CandidateView& candidate : session.snapshot().candidates) {
    if (candidate.state == state) fluents.push_back(candidate.fluent);
  }
  return hagl.bits(fluents);
}

void requireOrder(const std::vector<Alternative>& alternatives) {
  double last = 1;
  for (const Alternative& alternative : alternatives) {
    RC_ASSERT(alternative.probability >= 0 && alternative.probability <= last);
    last = alternative.probability;
  }
}

/// Each is as little as will do to have all else that was not refused.
void requireTrue(const Hagl& hagl, const Session& session) {
  const CandidateBits rest = hagl.all() & ~inState(hagl, session, CandidateState::NotWanted);
  RC_ASSERT(!session.outcome().alternatives.empty());
  for (const Alternative& alternative : session.outcome().alternatives) {
    const CandidateBits given_up = hagl.bits(alternative.given_up);
    RC_ASSERT(given_up != 0U && (given_up & ~rest) == 0U);
    RC_ASSERT(hagl.achievable(rest & ~given_up));
    for (std::size_t f = 0; f < hagl.size(); ++f) {
      const CandidateBits bit = CandidateBits{1} << f;
      if ((given_up & bit) != 0) RC_ASSERT(!hagl.achievable((rest & ~given_up) | bit));
    }
  }
  requireOrder(session.outcome().alternatives);
}

void giveUp(Session& session, const std::vector<Literal>& given_up) {
  for (const Literal& fluent : given_up) {
    const CandidateState state = session.snapshot().candidateOf(fluent)->state;
    const bool answered = state == CandidateState::Wanted || state == CandidateState::Unsure;
    const SubmitResult receipt = answered ? session.revise({fluent}, AnswerKind::No, "person")
                                          : session.answer({fluent}, AnswerKind::No, "person");
    EXPECT_TRUE(receipt.accepted) << receipt.message;
  }
}

/// Any of them leads to a plan at once, for all else that was not refused.
void requireThatOneCanBeTakenUp(RandomSource& random, const Hagl& hagl, Session& session) {
  const auto alternatives = session.outcome().alternatives;
  const std::vector<Literal>& chosen = alternatives[random.below(alternatives.size())].given_up;
  const CandidateBits kept =
      hagl.all() & ~inState(hagl, session, CandidateState::NotWanted) & ~hagl.bits(chosen);
  session.resume({});
  giveUp(session, chosen);
  RC_ASSERT(think(session) == State::Done);
  RC_ASSERT(code(session) == 1);
  RC_ASSERT(!validation::fault(hagl.robot, session.outcome().plan.steps, hagl.fluents(kept)));
}

RC_GTEST_PROP(SessionAlternatives, ADontKnowLeavesAChoiceUnderEveryPolicy, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  for (const UnsurePolicy policy :
       {UnsurePolicy::AsYes, UnsurePolicy::Defer, UnsurePolicy::Abort}) {
    Options chosen = anyOptions(random);
    chosen.unsure_policy = policy;
    Session session(chosen);
    session.begin(hagl.input);
    talk(session, [&](const Literal& fluent) {
      return oracles::chance(random, 0.5) ? AnswerKind::Unsure : honest(hagl)(fluent);
    });
    if (code(session) != 64) continue;
    requireTrue(hagl, session);
    requireThatOneCanBeTakenUp(random, hagl, session);
  }
}

RC_GTEST_PROP(SessionAlternatives, SoDoTheLimitOfQuestionsAndADecline, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Options chosen = anyOptions(random);
  const bool declines = oracles::chance(random, 0.5);
  if (!declines) chosen.max_questions = static_cast<int>(random.below(3));
  Session session(chosen);
  session.begin(hagl.input);
  talk(session, [&](const Literal& fluent) {
    return declines && oracles::chance(random, 0.4) ? AnswerKind::Decline : honest(hagl)(fluent);
  });
  if (code(session) != 61 && code(session) != 62) return;
  requireTrue(hagl, session);
  requireThatOneCanBeTakenUp(random, hagl, session);
}

TEST(SessionAlternatives, WhatIsKnownIsOfferedWhenTheTimeIsUp) {
  for (const ConflictMode mode : {ConflictMode::Full, ConflictMode::Lazy}) {
    Session session = atFirstQuestion(options("auto", mode));
    session.answerTimedOut("nobody is there");
    EXPECT_TRUE(session.outcome().alternatives.empty()) << "nobody is there to choose";
    Options no_time;
    no_time.time_limit = 1e-9;
    session.resume(no_time);
    if (think(session) == State::AwaitingAnswer)  // that much was known already
      session.answer(session.question()->fluents, AnswerKind::No, "me");
    ASSERT_EQ(think(session), State::Done);
    ASSERT_EQ(code(session), 53);
    ASSERT_FALSE(session.outcome().alternatives.empty());
    const std::vector<Literal> given_up = session.outcome().alternatives.front().given_up;
    EXPECT_FALSE(given_up.empty());
    session.resume({});
    giveUp(session, given_up);
    EXPECT_EQ(think(session), State::Done);
    EXPECT_EQ(code(session), 1);
  }
}

TEST(SessionAlternatives, AbortNamesWhatWouldDecide) {
  Options chosen;
  chosen.unsure_policy = UnsurePolicy::Abort;
  Session session = atFirstQuestion(chosen);
  session.answer(session.question()->fluents, AnswerKind::Unsure, "me");
  ASSERT_EQ(code(session), 64);
  EXPECT_EQ(session.outcome().conflict, literals({"(held b)"}));
  EXPECT_NE(session.outcome().message.find("depends on (held B)"), std::string::npos)
      << session.outcome().message;
  for (const Alternative& alternative : session.outcome().alternatives) {
    const auto& set = alternative.given_up;
    EXPECT_EQ(std::count(set.begin(), set.end(), literal("(held b)")), 1);
  }
  EXPECT_EQ(session.outcome().alternatives.size(), 2U) << "without (held a), or what is against it";
}

// Before anything was analysed nobody could say what there is to choose.
TEST(SessionAlternatives, AnEarlyDontKnowEndsADialogueOnlyWhereItIsOne) {
  Options chosen;
  chosen.unsure_policy = UnsurePolicy::Abort;
  Session session(chosen);
  session.begin(samples::desk());
  session.step();
  ASSERT_TRUE(session.answer(literals({"(held a)"}), AnswerKind::Unsure, "me").accepted);
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(code(session), 64);
  EXPECT_EQ(session.outcome().alternatives.size(), 2U);
  EXPECT_TRUE(session.questions().empty());
}

TEST(SessionAlternatives, WhatWasAnsweredYesIsHardlyGivenUp) {
  Session session = atFirstQuestion();
  talk(session, [](const Literal& fluent) {
    if (fluent == literal("(held b)")) return AnswerKind::No;
    return fluent == literal("(held a)") ? AnswerKind::Unsure : AnswerKind::Yes;
  });
  ASSERT_EQ(code(session), 64);
  const std::vector<Alternative>& alternatives = session.outcome().alternatives;
  ASSERT_EQ(alternatives.size(), 2U);
  EXPECT_EQ(alternatives.front().given_up, literals({"(held a)"}));
  EXPECT_LE(alternatives.back().probability, 0.02);
  EXPECT_GT(alternatives.front().probability, 0.02);
}

RC_GTEST_PROP(SessionAlternatives, AfterAProofNoneIsLikelierThanAYesTakenBack, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(anyOptions(random));
  session.begin(hagl.input);
  talk(session, [](const Literal& /*fluent*/) { return AnswerKind::Yes; });
  RC_ASSERT(code(session) == 52);
  RC_ASSERT(!session.outcome().alternatives.empty());
  requireOrder(session.outcome().alternatives);
  for (const Alternative& alternative : session.outcome().alternatives) {
    double most = 1;
    for (std::size_t i = 0; i < alternative.given_up.size(); ++i)
      most *= 0.02;
    RC_ASSERT(alternative.probability <= most);
  }
}

TEST(AlternativesAfter, AreNoneWhereTheOutcomeLeavesNoChoice) {
  samples::AnalysedDesk at;
  at.answer({"(held b)"}, AnswerKind::Yes);
  const auto after = [&](OutcomeCode code) {
    return alternativesAfter(code, at.dialogue, at.analysis, at.options);
  };
  EXPECT_TRUE(after(OutcomeCode::NoAnswer).empty());
  EXPECT_TRUE(after(OutcomeCode::Success).empty());
  ASSERT_EQ(after(OutcomeCode::ExpectationUnachievable).size(), 1U);
  EXPECT_EQ(after(OutcomeCode::ExpectationUnachievable).front().given_up,
            samples::literals({"(held b)"}));
  EXPECT_FALSE(after(OutcomeCode::TimeLimit).empty()) << "from the plans that are known";
}

}  // namespace
}  // namespace goal_alignment::session
