// SPDX-License-Identifier: BSD-3-Clause
#include "session/final_plan.h"

#include <gtest/gtest.h>

#include <vector>

#include "analysed_desk.h"

namespace goal_alignment::session {
namespace {

using samples::AnalysedDesk;
using samples::literals;

FinalPlan planFor(AnalysedDesk& at, const achievability::CandidateSet& set, PlanMode mode) {
  const achievability::Check check = at.analysis.robot().check(set, at.budget.limits());
  EXPECT_EQ(check.verdict, achievability::Verdict::Achievable);
  return makeFinalPlan(set, check.plan, at.dialogue, at.analysis, mode);
}

TEST(FinalPlan, PromisesWhatWasAskedForAndWhatIsWanted) {
  AnalysedDesk at;
  at.answer({"(held a)"}, AnswerKind::Yes);
  at.answer({"(free)", "(down a)", "(held b)"}, AnswerKind::No);
  const FinalPlan plan =
      planFor(at, at.setOf({"(down c)", "(held a)", "(red a)"}), PlanMode::First);
  EXPECT_EQ(plan.guaranteed, literals({"(down b)", "(held a)"}));
  EXPECT_EQ(plan.kept_unasked, literals({"(down c)", "(red a)"}));
  EXPECT_EQ(plan.not_wanted, literals({"(down a)", "(free)", "(held b)"}));
  EXPECT_TRUE(plan.assumed_not_wanted.empty());
  EXPECT_EQ(plan.cost, static_cast<std::int64_t>(plan.steps.size()));
}

TEST(FinalPlan, IsProvenCheapestWhereThatIsAskedFor) {
  AnalysedDesk at;
  const auto set = at.setOf({"(held a)"});
  EXPECT_FALSE(planFor(at, set, PlanMode::First).optimal);
  const FinalPlan optimal = planFor(at, set, PlanMode::Optimal);
  EXPECT_TRUE(optimal.optimal);
  EXPECT_EQ(optimal.cost, 1);
  EXPECT_EQ(planFor(at, set, PlanMode::Anytime).cost, 1);
}

}  // namespace
}  // namespace goal_alignment::session
