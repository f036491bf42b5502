// SPDX-License-Identifier: BSD-3-Clause
#include "session/conclusion.h"

#include <gtest/gtest.h>

#include "analysed_desk.h"

namespace goal_alignment::session {
namespace {

using samples::AnalysedDesk;
using samples::literals;

TEST(Conclusion, NamesTheConflictThatItRestsOn) {
  const AnalysedDesk at;
  const achievability::Conflict conflict{at.setOf({"(held b)"}), true, true};
  const Outcome outcome = expectationUnachievable(conflict, {}, at.analysis.problem());
  EXPECT_EQ(outcome.code, OutcomeCode::ExpectationUnachievable);
  EXPECT_EQ(outcome.conflict, literals({"(held b)"}));
  EXPECT_TRUE(outcome.conflict_proven);
  EXPECT_TRUE(outcome.conflict_minimal);
  EXPECT_EQ(outcome.message, "proven: no plan achieves what was asked for together with (held B)");
}

TEST(Conclusion, SaysWhatItDependsOn) {
  const AnalysedDesk at;
  const achievability::CandidateSet unsure = at.setOf({"(held a)"});
  const achievability::Conflict conflict{at.setOf({"(free)", "(held a)"}), false, false};
  const Outcome blocked = outcomeOf(Blocked{conflict, unsure}, at.analysis.problem());
  EXPECT_EQ(blocked.code, OutcomeCode::UnsureBlocks);
  EXPECT_EQ(blocked.message, "what is wanted may not be had all together; it depends on (held A)");
  const Outcome at_once = outcomeOf(Blocked{std::nullopt, unsure, true}, at.analysis.problem());
  EXPECT_TRUE(at_once.conflict.empty());
  EXPECT_EQ(at_once.message, "\"don't know\" ends this dialogue undecided; it depends on (held A)");
}

TEST(Conclusion, OfALimitIsNoProof) {
  const AnalysedDesk at;
  const Outcome outcome =
      outcomeOf(Exhausted{LimitReason::Memory, "it is open", std::nullopt}, at.analysis.problem());
  EXPECT_EQ(outcome.code, OutcomeCode::MemoryLimit);
  EXPECT_EQ(outcome.message, "it is open");
  EXPECT_FALSE(outcome.conflict_proven);
}

TEST(Conclusion, OfAPlanSaysWhatItDoesNotPromise) {
  const AnalysedDesk at;
  FinalPlan plan;
  plan.assumed_not_wanted = literals({"(held b)"});
  const Outcome outcome = outcomeOf(plan, at.analysis.problem());
  EXPECT_EQ(outcome.code, OutcomeCode::Success);
  EXPECT_NE(outcome.message.find("(held B)."), std::string::npos);
}

}  // namespace
}  // namespace goal_alignment::session
