// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

/// Answers of every kind: refused, volunteered, revised, unsure, declined, none at all.
namespace goal_alignment::session {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::answered;
using samples::anyOptions;
using samples::atFirstQuestion;
using samples::code;
using samples::desk;
using samples::expectedCode;
using samples::honest;
using samples::literal;
using samples::literals;
using samples::options;
using samples::talk;
using samples::think;
using samples::wanting;

std::string refusal(Session& session, const std::vector<Literal>& fluents, AnswerKind kind) {
  const SubmitResult receipt = session.answer(fluents, kind, "somebody");
  return receipt.accepted ? "accepted" : receipt.message;
}

TEST(Dialogue, RefusedAnswersHaveAReasonAndChangeNothing) {
  Session session = atFirstQuestion();
  session.answer(literals({"(down c)"}), AnswerKind::Yes, "me");
  const auto unchanged = [&] {
    return session.question() && session.question()->fluents == literals({"(held b)"}) &&
           session.questions().empty() &&
           session.snapshot().candidates[1].state == CandidateState::Wanted;
  };
  const auto yes = [&](const std::vector<std::string>& fluents) {
    return refusal(session, literals(fluents), AnswerKind::Yes);
  };
  EXPECT_NE(yes({"(down b)"}).find("specified"), std::string::npos);
  EXPECT_TRUE(unchanged());
  EXPECT_NE(yes({"(held c)"}).find("expected state"), std::string::npos);
  EXPECT_TRUE(unchanged());
  EXPECT_NE(yes({"(fly a)"}).find("(fly a)"), std::string::npos);
  EXPECT_TRUE(unchanged());
  EXPECT_NE(yes({"(down c)"}).find("answered already"), std::string::npos);
  EXPECT_TRUE(unchanged());
  EXPECT_NE(yes({}), "");
  // One bad fluent refuses the whole answer.
  EXPECT_NE(yes({"(held b)", "(held c)"}), "accepted");
  EXPECT_TRUE(unchanged());
  const SubmitResult receipt = session.revise(literals({"(held b)"}), AnswerKind::No, "me");
  EXPECT_FALSE(receipt.accepted);
  EXPECT_NE(receipt.message.find("not answered yet"), std::string::npos);
  EXPECT_TRUE(unchanged());
}

TEST(Dialogue, AnAnswerBeforeTheAnalysisIsRefused) {
  Session session{Options{}};
  EXPECT_FALSE(session.answer(literals({"(free)"}), AnswerKind::Yes, "me").accepted);
  session.begin(desk());
  EXPECT_FALSE(session.answer(literals({"(free)"}), AnswerKind::Yes, "me").accepted);
  EXPECT_FALSE(session.answer(literals({"(free)"}), AnswerKind::Decline, "me").accepted);
  EXPECT_EQ(session.state(), State::Analysing);
}

TEST(Dialogue, RemembersWhoAnswered) {
  Session session = atFirstQuestion();
  session.answer(literals({"(held b)"}), AnswerKind::No, "Ada");
  EXPECT_EQ(session.snapshot().candidates[4].answered_by, "Ada");
  EXPECT_EQ(session.snapshot().candidates[0].answered_by, "");
}

RC_GTEST_PROP(Dialogue, VolunteeredAnswersAreNotAskedForAgain, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(anyOptions(random));
  session.begin(hagl.input);
  std::set<Literal> volunteered;
  const auto volunteer = [&] {
    for (const Literal& fluent : hagl.candidates) {
      if (!oracles::chance(random, 0.2)) continue;
      const SubmitResult receipt = session.answer({fluent}, honest(hagl)(fluent), "eager");
      RC_ASSERT(receipt.accepted == receipt.message.empty());
      if (receipt.accepted) volunteered.insert(fluent);
    }
  };
  while (session.state() != State::Done) {
    session.step();
    if (session.state() == State::Analysing) volunteer();
    if (session.state() != State::AwaitingAnswer) continue;
    RC_ASSERT(volunteered.count(session.question()->fluents.front()) == 0U);
    if (oracles::chance(random, 0.5)) volunteer();
    if (session.state() != State::AwaitingAnswer) continue;  // that answered the open question
    const Literal fluent = session.question()->fluents.front();
    session.answer({fluent}, honest(hagl)(fluent), "person");
  }
  RC_ASSERT(code(session) == expectedCode(hagl));
  if (code(session) != 1) return;
  const std::vector<Literal> goal(hagl.true_goal.begin(), hagl.true_goal.end());
  RC_ASSERT(!validation::fault(hagl.robot, session.outcome().plan.steps, goal).has_value());
}

RC_GTEST_PROP(Dialogue, ARevisedAnswerKeepsTheOthers, ()) {
  RandomSource random = oracles::anySource();
  Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(anyOptions(random));
  session.begin(hagl.input);
  std::set<Literal> answered;
  for (int round = 0; round < 3; ++round) {
    for (const Literal& fluent : talk(session, honest(hagl))) {
      RC_ASSERT(answered.insert(fluent).second);  // nothing is asked twice, in any round
    }
    RC_ASSERT(code(session) == expectedCode(hagl));
    if (answered.empty()) return;
    auto changed = answered.begin();
    std::advance(changed, static_cast<std::ptrdiff_t>(random.below(answered.size())));
    if (hagl.true_goal.erase(*changed) == 0) hagl.true_goal.insert(*changed);
    RC_ASSERT(session.revise({*changed}, honest(hagl)(*changed), "person").accepted);
    RC_ASSERT(session.state() == State::Analysing);
  }
}

TEST(Dialogue, ARevisionWhileAQuestionIsOpenPutsTheQuestionAnew) {
  Session session = atFirstQuestion();
  session.answer(literals({"(held b)"}), AnswerKind::Yes, "me");
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(session.outcome().conflict, literals({"(held b)"}));
  EXPECT_TRUE(session.revise(literals({"(held b)"}), AnswerKind::No, "me").accepted);
  EXPECT_EQ(think(session), State::AwaitingAnswer);
  const std::size_t asked = session.questions().size();
  EXPECT_TRUE(session.revise(literals({"(held b)"}), AnswerKind::No, "me").accepted);
  EXPECT_EQ(think(session), State::AwaitingAnswer);
  EXPECT_EQ(session.questions().size(), asked);
}

/// Does not know some of it; tells what each fluent was answered in the end.
struct Hesitant {
  const Hagl& hagl;
  std::set<Literal> unknown;

  AnswerKind operator()(const Literal& fluent) const {
    return unknown.count(fluent) > 0 ? AnswerKind::Unsure : honest(hagl)(fluent);
  }
};

Hesitant anyHesitant(RandomSource& random, const Hagl& hagl) {
  Hesitant person{hagl, {}};
  for (const Literal& fluent : hagl.candidates) {
    if (oracles::chance(random, 0.4)) person.unknown.insert(fluent);
  }
  return person;
}

RC_GTEST_PROP(Unsure, AsYesKeepsThePromiseAndProvesNothingWithIt, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  const Hesitant person = anyHesitant(random, hagl);
  Session session(anyOptions(random));
  session.begin(hagl.input);
  talk(session, person);
  const CandidateBits yes = hagl.bits(answered(session, AnswerKind::Yes));
  const CandidateBits unsure = hagl.bits(answered(session, AnswerKind::Unsure));
  const CandidateBits conflict = hagl.bits(session.outcome().conflict);
  if (code(session) == 1) {
    std::vector<Literal> goal = hagl.specified;
    for (const Literal& fluent : hagl.fluents(yes | unsure))
      goal.push_back(fluent);
    goal.insert(goal.end(), hagl.true_goal.begin(), hagl.true_goal.end());
    RC_ASSERT(!validation::fault(hagl.robot, session.outcome().plan.steps, goal).has_value());
  } else if (code(session) == 52) {
    RC_ASSERT((conflict & ~yes) == 0U);
    RC_ASSERT(!hagl.achievable(conflict));
  } else {
    RC_ASSERT(code(session) == 64);
    RC_ASSERT(!hagl.achievable(yes | unsure));
    RC_ASSERT(!hagl.achievable(conflict));
    RC_ASSERT((conflict & unsure) != 0U);
    RC_ASSERT((conflict & ~(yes | unsure)) == 0U);
  }
}

RC_GTEST_PROP(Unsure, DeferAsksOnceMore, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  const Hesitant at_first = anyHesitant(random, hagl);
  Options chosen = anyOptions(random);
  chosen.unsure_policy = UnsurePolicy::Defer;
  RC_LOG() << chosen.policy << "\n";
  Session session(chosen);
  session.begin(hagl.input);
  std::map<Literal, int> times;
  talk(session, [&](const Literal& fluent) {
    return ++times[fluent] == 1 ? at_first(fluent) : honest(hagl)(fluent);
  });
  for (const auto& [fluent, count] : times) {
    RC_ASSERT(count <= (at_first.unknown.count(fluent) > 0 ? 2 : 1));
  }
  // Whoever knows at last gets the outcome as if they had always known.
  RC_ASSERT(code(session) == expectedCode(hagl));
}

RC_GTEST_PROP(Unsure, WhoNeverKnowsIsAskedTwiceAndNoMore, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  const Hesitant person = anyHesitant(random, hagl);
  Options chosen = anyOptions(random);
  chosen.unsure_policy = UnsurePolicy::Defer;
  Session session(chosen);
  session.begin(hagl.input);
  std::map<Literal, int> times;
  talk(session, [&](const Literal& fluent) {
    ++times[fluent];
    return person(fluent);
  });
  for (const auto& [fluent, count] : times)
    RC_ASSERT(count <= 2);
  RC_ASSERT(code(session) == 1 || code(session) == 52 || code(session) == 64);
  if (code(session) == 52) {
    const CandidateBits yes = hagl.bits(answered(session, AnswerKind::Yes));
    RC_ASSERT((hagl.bits(session.outcome().conflict) & ~yes) == 0U);
  }
}

// Two pairs of lamps, of each of which the robot can light one.
Input pairsOfLamps() {
  const auto domain = [](const std::string& precondition) {
    return "(define (domain lamps) (:predicates (free ?pair) (lit ?pair ?lamp) (done))\n"
           "(:action light :parameters (?pair ?lamp) :precondition (and " +
           precondition +
           ")\n  :effect (and (lit ?pair ?lamp) (not (free ?pair))))\n"
           "(:action finish :parameters () :precondition (and) :effect (and (done))))";
  };
  const std::string problem =
      "(define (problem p) (:domain lamps) (:objects a b one two)\n"
      "(:init (free a) (free b)) (:goal (done)))";
  Input input;
  input.robot_domain = {"robot_domain.pddl", domain("(free ?pair)")};
  input.human_domain = {"human_domain.pddl", domain("")};
  input.robot_problem = input.human_problem = {"problem.pddl", problem};
  for (const char* step : {"(light a one)", "(light a two)", "(light b one)", "(light b two)"})
    input.human_plan.push_back(GroundName::parse(step));
  input.human_plan.push_back(GroundName::parse("(finish)"));
  return input;
}

// What is not known of a conflict that another answer has settled is not asked once more.
TEST(Unsure, OnlyWhatBlocksIsAskedOnceMore) {
  std::size_t settled_by_another = 0;
  for (const char* policy : {"auto", "optimal", "ratio"}) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      Options chosen = options(policy, ConflictMode::Full, seed);
      chosen.unsure_policy = UnsurePolicy::Defer;
      Session session(chosen);
      session.begin(pairsOfLamps());
      std::map<Literal, int> times;
      talk(session, [&](const Literal& fluent) {
        ++times[fluent];
        return fluent == literal("(lit b two)") ? AnswerKind::No : AnswerKind::Unsure;
      });
      EXPECT_EQ(code(session), 64) << session.outcome().message;
      EXPECT_EQ(session.outcome().conflict, literals({"(lit a one)", "(lit a two)"}));
      EXPECT_EQ(times[literal("(lit a one)")], 2);
      EXPECT_EQ(times[literal("(lit a two)")], 2);
      EXPECT_LE(times[literal("(lit b one)")], 2);
      EXPECT_LE(times[literal("(lit b two)")], 1);
      if (times[literal("(lit b one)")] == 1 && times[literal("(lit b two)")] == 1)
        ++settled_by_another;
    }
  }
  EXPECT_GT(settled_by_another, 0U);
}

TEST(Unsure, AbortEndsUndecidedAtOnce) {
  Options chosen;
  chosen.unsure_policy = UnsurePolicy::Abort;
  Session session = atFirstQuestion(chosen);
  session.answer(literals({"(held b)"}), AnswerKind::Unsure, "me");
  EXPECT_EQ(session.state(), State::Done);
  EXPECT_EQ(code(session), 64);
}

TEST(Unsure, NamesWhatWouldDecide) {
  Session session = atFirstQuestion();
  talk(session, [](const Literal& fluent) {
    if (fluent == literal("(held b)")) return AnswerKind::No;
    return fluent == literal("(held a)") ? AnswerKind::Unsure : AnswerKind::Yes;
  });
  EXPECT_EQ(code(session), 64);
  EXPECT_NE(session.outcome().message.find("(held A)"), std::string::npos);
  // The answer that was missing decides it after all.
  EXPECT_TRUE(session.revise(literals({"(held a)"}), AnswerKind::No, "me").accepted);
  talk(session, wanting({"(free)", "(down a)"}));
  EXPECT_EQ(code(session), 1);
}

TEST(Dialogue, DeclineEndsItUndecided) {
  Session session = atFirstQuestion();
  EXPECT_TRUE(session.answer(literals({"(held b)"}), AnswerKind::Decline, "Ada").accepted);
  EXPECT_EQ(session.state(), State::Done);
  EXPECT_EQ(code(session), 61);
  EXPECT_FALSE(session.question().has_value());
  ASSERT_EQ(session.questions().size(), 1U);
  EXPECT_EQ(session.questions().front().answers.front(), AnswerKind::Decline);
  EXPECT_EQ(session.questions().front().fluents, literals({"(held b)"}));
}

TEST(Dialogue, AnOutcomeCannotBeDeclined) {
  Session session = atFirstQuestion();
  talk(session, wanting({"(held a)"}));
  const SubmitResult receipt = session.answer(literals({"(held b)"}), AnswerKind::Decline, "Ada");
  EXPECT_FALSE(receipt.accepted);
  EXPECT_NE(receipt.message, "");
  EXPECT_EQ(code(session), 1);
}

TEST(Dialogue, GivingUpKeepsTheAnswersForLater) {
  Session session = atFirstQuestion();
  session.answer(literals({"(held b)"}), AnswerKind::No, "me");
  think(session);
  session.answerTimedOut("nobody is here");
  EXPECT_EQ(session.state(), State::Done);
  EXPECT_EQ(code(session), 60);
  EXPECT_EQ(session.outcome().message, "nobody is here");
  EXPECT_EQ(session.snapshot().candidates[4].state, CandidateState::NotWanted);
  session.answerTimedOut("once more");  // there is nothing to wait for
  EXPECT_EQ(session.outcome().message, "nobody is here");
  session.answer(literals({"(held a)"}), AnswerKind::No, "me");
  EXPECT_EQ(session.state(), State::Analysing);
  EXPECT_EQ(think(session), State::Done);
  EXPECT_EQ(code(session), 1);
}

TEST(Dialogue, GivingUpWithoutAQuestionDoesNothing) {
  Session session{Options{}};
  session.answerTimedOut("nobody");
  EXPECT_EQ(session.state(), State::Idle);
  session.begin(desk());
  session.answerTimedOut("nobody");
  EXPECT_EQ(session.state(), State::Analysing);
}

}  // namespace
}  // namespace goal_alignment::session
