// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "analysed_desk.h"
#include "goal_alignment/session/session.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"
#include "session/views.h"

/// What an onlooker sees.
namespace goal_alignment::session {
namespace {

using oracles::Hagl;
using samples::atFirstQuestion;
using samples::code;
using samples::honest;
using samples::literal;
using samples::literals;
using samples::options;
using samples::talk;
using samples::think;
using samples::wanting;

std::vector<int> states(const Session& session) {
  std::vector<int> result;
  for (const CandidateView& candidate : session.snapshot().candidates) {
    result.push_back(static_cast<int>(candidate.state));
  }
  return result;
}

// (down a) (down c) (free) (held a) (held b) (red a); 1 open, 2 asked, 3 wanted, 4 not, 6 settled.
TEST(Snapshot, FollowsTheDialogue) {
  Session session = atFirstQuestion();
  EXPECT_EQ(states(session), (std::vector<int>{1, 6, 1, 1, 2, 6}));
  session.answer(literals({"(held b)"}), AnswerKind::No, "me");
  session.answer(literals({"(held a)"}), AnswerKind::Yes, "me");
  EXPECT_EQ(states(session)[4], 4);
  EXPECT_EQ(states(session)[3], 3);
  talk(session, wanting({}));
  EXPECT_EQ(states(session), (std::vector<int>{4, 6, 4, 3, 4, 6}));
  EXPECT_EQ(session.snapshot().state, State::Done);
  EXPECT_FLOAT_EQ(session.snapshot().progress, 1);
}

TEST(Snapshot, SaysSinceWhenTheRobotIsKnown) {
  Session session{Options{}};
  session.begin(samples::desk());
  EXPECT_FALSE(session.snapshot().robot_known);
  session.step();  // the models are read
  EXPECT_FALSE(session.snapshot().robot_known);
  session.step();  // and grounded
  EXPECT_TRUE(session.snapshot().robot_known);
  EXPECT_TRUE(session.snapshot().condition.empty());
}

TEST(Snapshot, ShowsThatNothingIsLeftToAskAndAPlanIsMade) {
  Session session = atFirstQuestion();
  EXPECT_FALSE(session.snapshot().planning);
  for (const CandidateView& candidate : session.snapshot().candidates)
    session.answer({candidate.fluent}, AnswerKind::No, "me");
  ASSERT_EQ(session.state(), State::Analysing);
  EXPECT_TRUE(session.snapshot().planning);
  think(session);
  EXPECT_EQ(code(session), 1);
  EXPECT_FALSE(session.snapshot().planning);
}

TEST(Snapshot, ShowsConflictsAndWhatIsLive) {
  Session session = atFirstQuestion();
  Snapshot view = session.snapshot();
  EXPECT_TRUE(view.conflicts_complete);
  ASSERT_EQ(view.conflicts.size(), 3U);
  for (const ConflictView& conflict : view.conflicts) {
    EXPECT_TRUE(conflict.live && conflict.proven && conflict.minimal);
  }
  EXPECT_EQ(view.candidates[3].conflicts.size(), 2U);
  EXPECT_FALSE(view.candidates[4].achievable);
  EXPECT_TRUE(view.candidates[3].achievable);
  EXPECT_TRUE(view.candidates[5].is_static);
  EXPECT_EQ(view.specified, literals({"(down b)"}));
  EXPECT_EQ(view.max_remaining, 4U);
  session.answer(literals({"(held a)"}), AnswerKind::No, "me");
  view = session.snapshot();
  EXPECT_TRUE(view.candidates[3].conflicts.empty());
  EXPECT_EQ(std::count_if(view.conflicts.begin(), view.conflicts.end(),
                          [](const ConflictView& conflict) { return conflict.live; }),
            1);
}

TEST(Snapshot, ThereIsOneInEveryState) {
  Session session{Options{}};
  EXPECT_EQ(session.snapshot().state, State::Idle);
  session.begin(samples::desk());
  while (session.state() != State::Done) {
    const Snapshot view = session.snapshot();
    EXPECT_EQ(view.state, session.state());
    EXPECT_GE(view.progress, 0);
    EXPECT_LE(view.progress, 1);
    if (session.step() == State::AwaitingAnswer) {
      session.answer(session.question()->fluents, AnswerKind::No, "me");
    }
  }
}

RC_GTEST_PROP(Snapshot, SettledIsNeverAskedAndOpenIsInALiveConflict, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  Session session(options("auto", ConflictMode::Full, random.below(100)));
  session.begin(hagl.input);
  std::vector<Literal> settled;
  while (think(session) == State::AwaitingAnswer) {
    const Literal fluent = session.question()->fluents.front();
    RC_ASSERT(std::count(settled.begin(), settled.end(), fluent) == 0);
    for (const CandidateView& candidate : session.snapshot().candidates) {
      if (candidate.state == CandidateState::Settled) settled.push_back(candidate.fluent);
      if (candidate.state == CandidateState::Open) RC_ASSERT(!candidate.conflicts.empty());
      RC_ASSERT((candidate.state == CandidateState::Asked) == (candidate.fluent == fluent));
      RC_ASSERT(candidate.probability >= 0.02 && candidate.probability <= 0.98);
    }
    session.answer({fluent}, honest(hagl)(fluent), "person");
  }
  for (const CandidateView& candidate : session.snapshot().candidates) {
    RC_ASSERT(candidate.state != CandidateState::Asked);
  }
}

TEST(Snapshot, FindsCandidatesAndConflicts) {
  const Session session = atFirstQuestion();
  const Snapshot view = session.snapshot();
  ASSERT_NE(view.candidateOf(literal("(held a)")), nullptr);
  EXPECT_EQ(view.candidateOf(literal("(held a)"))->fluent, literal("(held a)"));
  EXPECT_EQ(view.candidateOf(literal("(down b)")), nullptr);  // it was asked for
  EXPECT_EQ(view.candidateOf(literal("(not (held a))")), nullptr);
  const ConflictView* conflict = view.conflictOf(literals({"(held a)", "(free)"}));
  ASSERT_NE(conflict, nullptr);
  EXPECT_EQ(view.conflictOf(literals({"(free)", "(held a)"})), conflict);
  EXPECT_TRUE(conflict->isOf(literals({"(free)", "(held a)"})));
  EXPECT_FALSE(conflict->isOf(literals({"(free)"})));
  EXPECT_EQ(view.conflictOf(literals({"(free)"})), nullptr);
  EXPECT_EQ(view.conflictOf({}), nullptr);
}

TEST(SnapshotOf, SaysThatAPlanIsSoughtWhereNoConflictIsLeft) {
  samples::AnalysedDesk at;
  Stage stage;
  stage.state = State::Analysing;
  stage.is_deciding = true;
  EXPECT_FALSE(snapshotOf(stage, at.dialogue, at.analysis, std::nullopt).planning);
  at.answer({"(held a)", "(held b)"}, AnswerKind::No);
  const Snapshot then = snapshotOf(stage, at.dialogue, at.analysis, std::nullopt);
  EXPECT_TRUE(then.planning);
  EXPECT_EQ(then.conflicts.size(), 3U);
  EXPECT_FALSE(then.conflicts.front().live);
}

}  // namespace
}  // namespace goal_alignment::session
