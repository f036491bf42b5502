// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "goal_alignment/session/session.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

/// Questions about several fluents: "which of these matter to you?"
namespace goal_alignment::session {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::code;
using samples::expectedCode;
using samples::honest;
using samples::literals;
using samples::think;

Options groupsOf(std::size_t most) {
  Options options;
  options.max_group_size = most;
  return options;
}

/// Answers the open question's fluents one by one, in any order.
void answerInAnyOrder(RandomSource& random, Session& session, const Hagl& hagl) {
  std::vector<Literal> fluents = session.question()->fluents;
  for (std::size_t i = fluents.size(); i > 1; --i)
    std::swap(fluents[i - 1], fluents[random.below(i)]);
  for (const Literal& fluent : fluents) {
    if (session.state() != State::AwaitingAnswer) return;  // the rest does not matter any more
    RC_ASSERT(session.answer({fluent}, honest(hagl)(fluent), "person").accepted);
  }
}

std::set<Literal> answeredSoFar(const Session& session) {
  std::set<Literal> fluents;
  for (const CandidateView& candidate : session.snapshot().candidates) {
    const CandidateState state = candidate.state;
    if (state == CandidateState::Wanted || state == CandidateState::NotWanted)
      fluents.insert(candidate.fluent);
  }
  return fluents;
}

RC_GTEST_PROP(Group, EndsAsBruteForceSays, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Options chosen = samples::anyOptions(random);
  chosen.max_group_size = 2 + random.below(5);
  RC_LOG() << chosen.policy << "\n";
  Session session(chosen);
  session.begin(hagl.input);
  std::set<Literal> answered;
  std::size_t rounds = 0;
  while (think(session) == State::AwaitingAnswer) {
    const QuestionView& question = *session.question();
    RC_ASSERT(question.asked == rounds++);
    RC_ASSERT(!question.fluents.empty());
    RC_ASSERT(question.fluents.size() <= chosen.max_group_size);
    RC_ASSERT(question.reasons.size() == question.fluents.size());
    RC_ASSERT(question.probabilities.size() == question.fluents.size());
    for (const Literal& fluent : question.fluents)
      RC_ASSERT(answered.count(fluent) == 0U);
    answerInAnyOrder(random, session, hagl);
    // What came up as needless before it was answered may come up again with a new conflict.
    answered = answeredSoFar(session);
  }
  RC_ASSERT(code(session) == expectedCode(hagl));
  RC_ASSERT(session.questions().size() == rounds);
  for (const QuestionRecord& record : session.questions()) {
    RC_ASSERT(record.answers.size() == record.fluents.size());
    RC_ASSERT(record.reasons.size() == record.fluents.size());
    for (std::size_t i = 0; i < record.fluents.size(); ++i)
      RC_ASSERT(record.answers[i] == honest(hagl)(record.fluents[i]));
  }
}

RC_GTEST_PROP(Group, EveryFluentIsInALiveConflict, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(groupsOf(2 + random.below(5)));
  session.begin(hagl.input);
  CandidateBits no = 0;
  while (think(session) == State::AwaitingAnswer) {
    const QuestionView question = *session.question();
    for (std::size_t i = 0; i < question.fluents.size(); ++i) {
      const CandidateBits conflict = hagl.bits(question.reasons[i].conflict);
      RC_ASSERT(hagl.minimalConflicts().count(conflict) > 0);
      RC_ASSERT((conflict & no) == 0U);
      RC_ASSERT((conflict & hagl.bits({question.fluents[i]})) != 0U);
    }
    for (const Literal& fluent : question.fluents) {
      session.answer({fluent}, honest(hagl)(fluent), "person");
      if (!hagl.wants(fluent)) no |= hagl.bits({fluent});
    }
  }
}

TEST(Group, APartThatIsAnsweredLeavesTheRestOpen) {
  Session session = samples::atFirstQuestion(groupsOf(6));
  const std::vector<Literal> fluents = session.question()->fluents;
  ASSERT_GE(fluents.size(), 2U);
  ASSERT_EQ(fluents.front(), literals({"(held b)"}).front());
  // (held a) is in conflicts with what is left, so that the question still matters.
  EXPECT_TRUE(session.answer({fluents[1]}, AnswerKind::Yes, "me").accepted);
  EXPECT_EQ(session.state(), State::AwaitingAnswer);
  EXPECT_EQ(session.question()->fluents, fluents);
  EXPECT_TRUE(session.questions().empty());
  for (const Literal& fluent : fluents) {
    if (fluent != fluents[1]) session.answer({fluent}, AnswerKind::No, "me");
  }
  ASSERT_EQ(session.questions().size(), 1U);
  EXPECT_EQ(session.questions().front().fluents, fluents);
  EXPECT_EQ(session.questions().front().answers[1], AnswerKind::Yes);
}

TEST(Group, WhatTheFirstAnswersMakeNeedlessIsRecordedAllTheSame) {
  Session session = samples::atFirstQuestion(groupsOf(6));
  const std::vector<Literal> fluents = session.question()->fluents;
  ASSERT_GE(fluents.size(), 3U);
  ASSERT_EQ(fluents.front(), literals({"(held b)"}).front());
  // It can't be had, so that nothing else matters.
  EXPECT_TRUE(session.answer({fluents[0]}, AnswerKind::Yes, "me").accepted);
  EXPECT_FALSE(session.question().has_value());
  ASSERT_EQ(session.questions().size(), 1U);
  EXPECT_EQ(session.questions().front().fluents.size(), 1U);
  for (std::size_t i = fluents.size(); i-- > 1;)
    EXPECT_TRUE(session.answer({fluents[i]}, AnswerKind::No, "me").accepted);
  think(session);
  EXPECT_EQ(code(session), 52);
  ASSERT_EQ(session.questions().size(), 1U);
  const QuestionRecord& record = session.questions().front();
  EXPECT_EQ(record.fluents, fluents);
  EXPECT_EQ(record.answers.front(), AnswerKind::Yes);
  EXPECT_EQ(record.answers.back(), AnswerKind::No);
  for (const Reason& reason : record.reasons)
    EXPECT_FALSE(reason.conflict.empty());
}

RC_GTEST_PROP(Group, EveryFluentThatWasShownAndAnsweredIsRecorded, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Options chosen = samples::anyOptions(random);
  chosen.max_group_size = 2 + random.below(5);
  Session session(chosen);
  session.begin(hagl.input);
  std::size_t rounds = 0;
  while (think(session) == State::AwaitingAnswer) {
    const std::vector<Literal> shown = session.question()->fluents;
    for (const Literal& fluent : shown)
      RC_ASSERT(session.answer({fluent}, honest(hagl)(fluent), "person").accepted);
    RC_ASSERT(session.questions().size() == ++rounds);
    const QuestionRecord& record = session.questions().back();
    RC_ASSERT(record.fluents == shown);
    RC_ASSERT(record.round == rounds);
    for (std::size_t i = 0; i < shown.size(); ++i)
      RC_ASSERT(record.answers[i] == honest(hagl)(shown[i]));
  }
  RC_ASSERT(code(session) == expectedCode(hagl));
}

TEST(Group, UnsureAndDeclineAreSaidOfAll) {
  Session session = samples::atFirstQuestion(groupsOf(6));
  const std::vector<Literal> fluents = session.question()->fluents;
  EXPECT_TRUE(session.answer(fluents, AnswerKind::Decline, "me").accepted);
  EXPECT_EQ(code(session), 61);
  EXPECT_EQ(session.questions().front().answers,
            std::vector<AnswerKind>(fluents.size(), AnswerKind::Decline));
  session = samples::atFirstQuestion(groupsOf(6));
  EXPECT_TRUE(session.answer(session.question()->fluents, AnswerKind::Unsure, "me").accepted);
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(code(session), 64);
}

TEST(Group, AQuestionThatNoLongerMattersIsTakenBack) {
  Session session = samples::atFirstQuestion();
  session.answer(literals({"(held b)"}), AnswerKind::No, "me");
  think(session);
  const Literal open = session.question()->fluents.front();
  // The conflicts left are {held a, free} and {held a, down a}.
  const bool about_a = open == literals({"(held a)"}).front();
  for (const Literal& fluent :
       about_a ? literals({"(free)", "(down a)"}) : literals({"(held a)"})) {
    EXPECT_TRUE(session.answer({fluent}, AnswerKind::No, "me").accepted);
  }
  EXPECT_FALSE(session.question().has_value());
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(code(session), 1);
  EXPECT_EQ(session.questions().size(), 1U);
}

TEST(Group, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(Session{groupsOf(0)}, std::invalid_argument);
  Options options;
  options.max_extra_cost = -1;
  EXPECT_THROW(Session{options}, std::invalid_argument);
}

}  // namespace
}  // namespace goal_alignment::session
