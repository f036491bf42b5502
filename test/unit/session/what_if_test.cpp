// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "analysed_desk.h"
#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"
#include "session/what_if.h"

/// What would follow from answers that nobody has given.
namespace goal_alignment::session {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::code;
using samples::expectedCode;
using samples::honest;
using samples::literals;
using Kind = Consequence::Kind;

constexpr double kSeconds = 60;

CandidateBits inState(const Session& session, const Hagl& hagl, CandidateState state) {
  std::vector<Literal> fluents;
  for (const CandidateView& candidate : session.snapshot().candidates)
    if (candidate.state == state) fluents.push_back(candidate.fluent);
  return hagl.bits(fluents);
}

void supposeAnything(RandomSource& random, Session& session, const Hagl& hagl) {
  CandidateBits yes = random.below(hagl.all() + 1) & random.below(hagl.all() + 1);
  const CandidateBits no = random.below(hagl.all() + 1) & ~yes;
  const Consequence found = session.whatIf(hagl.fluents(yes), hagl.fluents(no), kSeconds);
  const CandidateBits not_wanted = no | (inState(session, hagl, CandidateState::NotWanted) & ~yes);
  yes |= inState(session, hagl, CandidateState::Wanted) & ~no;
  const CandidateBits wished = hagl.all() & ~not_wanted;
  switch (found.kind) {
    case Kind::Plan: {
      std::vector<Literal> goal = hagl.fluents(wished);
      goal.insert(goal.end(), hagl.specified.begin(), hagl.specified.end());
      RC_ASSERT(!validation::fault(hagl.robot, found.plan, goal).has_value());
      break;
    }
    case Kind::NoPlan:
      RC_ASSERT((hagl.bits(found.conflict) & ~yes) == 0U);
      RC_ASSERT(!hagl.achievable(hagl.bits(found.conflict)));
      break;
    case Kind::Questions:
      RC_ASSERT(hagl.achievable(yes));
      RC_ASSERT(!hagl.achievable(wished));
      break;
    case Kind::Unknown:
      RC_FAIL("the time suffices for this");
  }
}

RC_GTEST_PROP(WhatIf, AgreesWithBruteForceAndChangesNothing, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(samples::anyOptions(random));
  session.begin(hagl.input);
  while (samples::think(session) == State::AwaitingAnswer) {
    const std::vector<Literal> open = session.question()->fluents;
    const std::size_t answered = session.questions().size();
    supposeAnything(random, session, hagl);
    RC_ASSERT(session.state() == State::AwaitingAnswer);
    RC_ASSERT(session.question()->fluents == open);
    RC_ASSERT(session.questions().size() == answered);
    session.answer(open, honest(hagl)(open.front()), "person");
  }
  RC_ASSERT(code(session) == expectedCode(hagl));
  supposeAnything(random, session, hagl);
  RC_ASSERT(code(session) == expectedCode(hagl));
}

TEST(WhatIf, SpeaksOfTheDesk) {
  Session session = samples::atFirstQuestion();
  Consequence found = session.whatIf(literals({"(held b)"}), {}, kSeconds);
  EXPECT_EQ(found.kind, Kind::NoPlan);
  EXPECT_EQ(found.conflict, literals({"(held b)"}));
  found = session.whatIf({}, literals({"(held a)", "(held b)"}), kSeconds);
  EXPECT_EQ(found.kind, Kind::Plan);
  EXPECT_TRUE(found.plan.empty());
  found = session.whatIf(literals({"(held a)"}), literals({"(held b)"}), kSeconds);
  EXPECT_EQ(found.kind, Kind::Questions);
  EXPECT_EQ(found.max_remaining, 2U);  // (free), (down a)
  EXPECT_FALSE(found.conflict.empty());
}

TEST(WhatIf, NeedsCandidatesAndModels) {
  Session session{Options{}};
  session.begin(samples::desk());
  EXPECT_THROW(session.whatIf(literals({"(fly a)"}), {}, kSeconds), std::invalid_argument);
  session.step();
  EXPECT_EQ(session.whatIf(literals({"(held b)"}), {}, kSeconds).kind, Kind::Unknown);
  samples::think(session);
  EXPECT_THROW(session.whatIf(literals({"(fly a)"}), {}, kSeconds), std::invalid_argument);
  EXPECT_THROW(session.whatIf(literals({"(held b)"}), literals({"(held b)"}), kSeconds),
               std::invalid_argument);
}

TEST(Suppose, ChangesNoAnswer) {
  const samples::AnalysedDesk at;
  const auto then = suppose(at.dialogue, literals({"(free)"}), literals({"(held a)"}));
  EXPECT_EQ(then[2], questions::Knowledge::Wanted);
  EXPECT_EQ(then[3], questions::Knowledge::NotWanted);
  EXPECT_EQ(at.dialogue.knowledge()[2], questions::Knowledge::Open);
  EXPECT_THROW(suppose(at.dialogue, literals({"(free)"}), literals({"(free)"})),
               std::invalid_argument);
}

}  // namespace
}  // namespace goal_alignment::session
