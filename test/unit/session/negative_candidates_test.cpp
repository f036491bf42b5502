// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/lifted_space.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

/// Side effects: that something is not so may be wanted, too.
namespace goal_alignment::session {
namespace {

using oracles::Hagl;
using samples::code;
using samples::literals;
using samples::talk;

constexpr std::size_t kMaxCandidates = 13;

/// The problem with all candidates that the session has; of the new ones some are wanted.
Hagl withCandidatesOf(const Session& session, Hagl hagl, RandomSource& random) {
  hagl.candidates.clear();
  for (const CandidateView& candidate : session.snapshot().candidates) {
    hagl.candidates.push_back(candidate.fluent);
    if (candidate.fluent.negated && oracles::chance(random, 0.3))
      hagl.true_goal.insert(candidate.fluent);
  }
  return hagl;
}

void requireComplete(const Hagl& before, const Hagl& after) {
  std::set<GroundName> expected;
  for (const auto* list : {&before.specified, &before.candidates})
    for (const Literal& literal : *list)
      if (!literal.negated) expected.insert(literal.atom);
  const std::set<Literal> specified(before.specified.begin(), before.specified.end());
  const std::set<Literal> found(after.candidates.begin(), after.candidates.end());
  for (const oracles::Atoms& state : oracles::LiftedSpace(before.robot, 10'000).states()) {
    for (const GroundName& atom : state) {
      const Literal negation = {atom, true};
      if (expected.count(atom) + specified.count(negation) > 0) continue;
      RC_ASSERT(found.count(negation) == 1U);
    }
  }
  for (const Literal& candidate : after.candidates) {
    RC_ASSERT(candidate.negated == (expected.count(candidate.atom) == 0U));
    RC_ASSERT(specified.count(candidate) == 0U);
  }
}

RC_GTEST_PROP(NegativeCandidates, AreAllThatTheRobotMayMakeSoUnexpectedly, ()) {
  RandomSource random = oracles::anySource();
  const Hagl positive = oracles::randomHagl(random, 6);
  RC_LOG() << samples::text(positive);
  Options chosen = samples::anyOptions(random);
  chosen.negative_candidates = true;
  chosen.max_group_size = 1 + random.below(4);
  Session session(chosen);
  session.begin(positive.input);
  session.step();  // the models are read
  Hagl hagl = withCandidatesOf(session, positive, random);
  requireComplete(positive, hagl);
  RC_PRE(hagl.size() <= kMaxCandidates);
  hagl.analyse();
  talk(session, samples::honest(hagl));
  RC_LOG() << session.outcome().message << "\n";
  RC_ASSERT(code(session) == samples::expectedCode(hagl));
  if (code(session) == 1) {
    const std::vector<Literal> goal(hagl.true_goal.begin(), hagl.true_goal.end());
    RC_ASSERT(!validation::fault(hagl.robot, session.outcome().plan.steps, goal).has_value());
  }
  if (code(session) == 52) RC_ASSERT(!hagl.achievable(hagl.bits(session.outcome().conflict)));
}

TEST(NegativeCandidates, ASideEffectIsAskedAboutLikeAnythingElse) {
  Options chosen;
  chosen.negative_candidates = true;
  Session session(chosen);
  session.begin(samples::desk());
  talk(session, samples::wanting({"(not (held c))", "(down a)"}));
  EXPECT_EQ(code(session), 1);
  EXPECT_TRUE(session.outcome().plan.steps.empty());
  bool any = false;
  for (const CandidateView& candidate : session.snapshot().candidates)
    any = any || candidate.fluent == literals({"(not (held c))"}).front();
  EXPECT_TRUE(any);
}

}  // namespace
}  // namespace goal_alignment::session
