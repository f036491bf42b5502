// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

/// Predicates that nobody is asked about.
namespace goal_alignment::session {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::atFirstQuestion;
using samples::code;
using samples::honest;
using samples::literals;
using samples::talk;
using samples::wanting;

struct Hidden {
  std::set<std::string> wanted;
  std::set<std::string> not_wanted;
};

Hidden anyHidden(RandomSource& random, const Hagl& hagl) {
  Hidden hidden;
  for (const Literal& fluent : hagl.candidates) {
    const std::string& name = fluent.atom.name;
    if (hidden.wanted.count(name) + hidden.not_wanted.count(name) > 0) continue;
    if (oracles::chance(random, 0.3))
      hidden.wanted.insert(name);
    else if (oracles::chance(random, 0.3))
      hidden.not_wanted.insert(name);
  }
  return hidden;
}

CandidateBits bitsOf(const Hagl& hagl, const std::set<std::string>& predicates) {
  std::vector<Literal> fluents;
  for (const Literal& fluent : hagl.candidates)
    if (predicates.count(fluent.atom.name) > 0) fluents.push_back(fluent);
  return hagl.bits(fluents);
}

RC_GTEST_PROP(Hidden, NoVerdictRestsOnWhatWasAssumed, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const Hidden hidden = anyHidden(random, hagl);
  Options chosen = samples::anyOptions(random);
  chosen.max_group_size = 1 + random.below(3);
  if (oracles::chance(random, 0.3)) chosen.unsure_policy = UnsurePolicy::Defer;
  chosen.assumed_wanted_predicates = {hidden.wanted.begin(), hidden.wanted.end()};
  chosen.assumed_unwanted_predicates = {hidden.not_wanted.begin(), hidden.not_wanted.end()};
  Session session(chosen);
  session.begin(hagl.input);
  for (const Literal& fluent : talk(session, honest(hagl))) {
    RC_ASSERT(hidden.wanted.count(fluent.atom.name) == 0U);
    RC_ASSERT(hidden.not_wanted.count(fluent.atom.name) == 0U);
  }
  const CandidateBits kept = bitsOf(hagl, hidden.wanted);
  const CandidateBits given_up = bitsOf(hagl, hidden.not_wanted);
  const CandidateBits wanted = hagl.wanted() & ~kept & ~given_up;
  RC_LOG() << session.outcome().message << "\n";
  if (!hagl.achievable(0)) {
    RC_ASSERT(code(session) == 51);
  } else if (hagl.achievable(wanted | kept)) {
    RC_ASSERT(code(session) == 1);
    const FinalPlan& plan = session.outcome().plan;
    std::vector<Literal> goal = hagl.fluents(wanted | kept);
    goal.insert(goal.end(), hagl.specified.begin(), hagl.specified.end());
    RC_ASSERT(!validation::fault(hagl.robot, plan.steps, goal).has_value());
    RC_ASSERT((hagl.bits(plan.not_wanted) & (kept | given_up)) == 0U);
    // All of S^H at once leaves nothing to give up.
    if (!hagl.achievable(hagl.all())) RC_ASSERT(hagl.bits(plan.assumed_not_wanted) == given_up);
  } else if (hagl.achievable(wanted)) {
    RC_ASSERT(code(session) == 64);
  } else {
    RC_ASSERT(code(session) == 64 || code(session) == 52);
  }
  const CandidateBits conflict = code(session) == 51 ? 0 : hagl.bits(session.outcome().conflict);
  if (code(session) == 52) {
    RC_ASSERT((conflict & ~wanted) == 0U);
    RC_ASSERT(!hagl.achievable(conflict));
  }
  if (code(session) == 64) {
    RC_ASSERT((conflict & ~(wanted | kept)) == 0U);
    RC_ASSERT((conflict & kept) != 0U);
  }
}

TEST(Hidden, TheResultSaysWhatWasAssumed) {
  Options chosen;
  chosen.assumed_unwanted_predicates = {"HELD"};
  Session session(chosen);
  session.begin(samples::desk());
  EXPECT_TRUE(talk(session, wanting({"(free)"})).empty());
  EXPECT_EQ(code(session), 1);
  EXPECT_EQ(session.outcome().plan.assumed_not_wanted, literals({"(held a)", "(held b)"}));
  EXPECT_TRUE(session.outcome().plan.not_wanted.empty());
  EXPECT_NE(session.outcome().message.find("(held A)"), std::string::npos)
      << session.outcome().message;
  EXPECT_TRUE(session.snapshot().candidates[3].assumed);
}

TEST(Hidden, WhatIsVolunteeredCountsInstead) {
  Options chosen;
  chosen.assumed_unwanted_predicates = {"held"};
  chosen.assumed_wanted_predicates = {"down"};
  Session session(chosen);
  session.begin(samples::desk());
  session.step();  // the models are read
  EXPECT_TRUE(session.answer(literals({"(held a)"}), AnswerKind::Yes, "me").accepted);
  EXPECT_FALSE(session.snapshot().candidates[3].assumed);
  EXPECT_FALSE(session.answer(literals({"(held a)"}), AnswerKind::No, "me").accepted);
  talk(session, wanting({}));
  EXPECT_EQ(code(session), 64);  // (held a), and (down a) that was assumed
  EXPECT_NE(session.outcome().message.find("(down A)"), std::string::npos);
  EXPECT_TRUE(session.revise(literals({"(down a)"}), AnswerKind::No, "me").accepted);
  talk(session, wanting({}));
  EXPECT_EQ(code(session), 1);
}

TEST(Hidden, WhatNobodyIsAskedAboutIsNotAskedOnceMore) {
  Options chosen;
  chosen.assumed_wanted_predicates = {"held"};
  chosen.unsure_policy = UnsurePolicy::Defer;
  Session session(chosen);
  session.begin(samples::desk());
  EXPECT_TRUE(talk(session, wanting({})).empty());
  EXPECT_EQ(code(session), 64);
}

}  // namespace
}  // namespace goal_alignment::session
