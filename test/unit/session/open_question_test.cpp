// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "analysed_desk.h"
#include "goal_alignment/session/session.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"
#include "session/open_question.h"

/// What a question says of itself, also after answers to something else.
namespace goal_alignment::session {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::atFirstQuestion;
using samples::honest;
using samples::literal;
using samples::literals;
using samples::options;
using samples::think;

/// The candidates in conflicts that these answers leave live, but for those answered.
CandidateBits relevantCandidates(const Hagl& hagl, CandidateBits yes, CandidateBits no) {
  CandidateBits result = 0;
  for (const CandidateBits conflict : hagl.minimalConflicts()) {
    if ((conflict & no) == 0) result |= conflict;
  }
  return result & ~yes & ~no;
}

std::size_t count(CandidateBits set) {
  std::size_t size = 0;
  for (; set != 0; set &= set - 1)
    ++size;
  return size;
}

/// Bound, reasons and prospects are those that enumeration gives for the answers so far.
void requireFresh(const Hagl& hagl, const QuestionView& question, CandidateBits yes,
                  CandidateBits no) {
  using Ending = questions::AnswerEffect::Ending;
  const CandidateBits asked = hagl.bits(question.fluents);
  const CandidateBits now = relevantCandidates(hagl, yes, no);
  RC_ASSERT(question.max_remaining == count(now));
  const CandidateBits reason = hagl.bits(question.reasons.front().conflict);
  RC_ASSERT(hagl.minimalConflicts().count(reason) > 0);
  RC_ASSERT((reason & asked) == asked && (reason & no) == 0);
  const CandidateBits then = relevantCandidates(hagl, yes, no | asked);
  RC_ASSERT((question.if_no.ending == Ending::Plan) == (then == 0));
  RC_ASSERT(question.if_no.left == count(then));
  RC_ASSERT(question.if_no.settled == count(now & ~asked) - count(then));
  const auto within = [&](CandidateBits conflict) { return (conflict & ~(yes | asked)) == 0; };
  const std::set<CandidateBits> conflicts = hagl.minimalConflicts();
  const bool no_plan = std::any_of(conflicts.begin(), conflicts.end(), within);
  RC_ASSERT((question.if_yes.ending == Ending::NoPlan) == no_plan);
}

RC_GTEST_PROP(Asking, AnOpenQuestionSaysWhatIsSoAfterOtherAnswers, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(options("auto", ConflictMode::Full, random.below(100)));
  session.begin(hagl.input);
  CandidateBits yes = 0;
  CandidateBits no = 0;
  const auto answer = [&](const Literal& fluent) {
    (hagl.wants(fluent) ? yes : no) |= hagl.bits({fluent});
    RC_ASSERT(session.answer({fluent}, honest(hagl)(fluent), "person").accepted);
  };
  while (think(session) == State::AwaitingAnswer) {
    const std::vector<Literal> asked = session.question()->fluents;
    requireFresh(hagl, *session.question(), yes, no);
    for (const Literal& fluent : hagl.candidates) {
      const bool answered = ((yes | no | hagl.bits(asked)) & hagl.bits({fluent})) != 0;
      if (answered || !oracles::chance(random, 0.4)) continue;
      answer(fluent);
      if (session.state() != State::AwaitingAnswer) break;
      RC_ASSERT(session.question()->fluents == asked);
      RC_ASSERT(session.snapshot().max_remaining == session.question()->max_remaining);
      requireFresh(hagl, *session.question(), yes, no);
    }
    if (session.state() == State::AwaitingAnswer) answer(asked.front());
  }
}

TEST(Asking, AReasonThatAnotherAnswerHasSettledMakesRoomForTheOtherOne) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Session session = atFirstQuestion(options("auto", ConflictMode::Full, seed));
    ASSERT_TRUE(session.answer(literals({"(held b)"}), AnswerKind::No, "me").accepted);
    ASSERT_EQ(think(session), State::AwaitingAnswer);
    if (session.question()->fluents.front() != literal("(held a)")) continue;
    const std::vector<Literal> first = session.question()->reasons.front().conflict;
    const bool about_free = std::count(first.begin(), first.end(), literal("(free)")) > 0;
    const Literal partner = literal(about_free ? "(free)" : "(down a)");
    EXPECT_EQ(session.question()->max_remaining, 3U);
    ASSERT_TRUE(session.answer({partner}, AnswerKind::No, "me").accepted);
    ASSERT_EQ(session.state(), State::AwaitingAnswer);
    const std::vector<Literal> then = session.question()->reasons.front().conflict;
    EXPECT_NE(then, first);
    EXPECT_EQ(then.size(), 2U);
    EXPECT_EQ(session.question()->max_remaining, 2U);
    return;
  }
  FAIL() << "nobody was asked about (held a)";
}

TEST(Asking, OfAGroupTheProspectsAreThoseOfWhatIsLeft) {
  Options chosen;
  chosen.max_group_size = 6;
  Session session = atFirstQuestion(chosen);
  const std::vector<Literal> fluents = session.question()->fluents;
  ASSERT_GE(fluents.size(), 3U);
  const std::size_t before = session.question()->max_remaining;
  EXPECT_TRUE(session.answer({literal("(held a)")}, AnswerKind::No, "me").accepted);
  ASSERT_EQ(session.state(), State::AwaitingAnswer) << "(held b) still matters";
  EXPECT_LT(session.question()->max_remaining, before);
  EXPECT_EQ(session.question()->max_remaining, 1U);
  EXPECT_EQ(session.question()->if_no.ending, questions::AnswerEffect::Ending::Plan);
  EXPECT_EQ(session.question()->if_yes.ending, questions::AnswerEffect::Ending::NoPlan);
}

TEST(OpenQuestion, MattersAsLongAsItsConflictIsLive) {
  samples::AnalysedDesk at;
  at.dialogue.ask({{*at.dialogue.find(literal("(free)")), {}}});
  const QuestionView question = openQuestion(at.dialogue, at.analysis, at.options);
  EXPECT_EQ(question.fluents, literals({"(free)"}));
  EXPECT_TRUE(question.at_end);
  EXPECT_TRUE(stillMatters(question, at.dialogue, at.analysis));
  at.answer({"(held a)"}, AnswerKind::No);
  EXPECT_FALSE(stillMatters(question, at.dialogue, at.analysis));
}

}  // namespace
}  // namespace goal_alignment::session
