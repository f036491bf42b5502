// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/session/outcome.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::session {
namespace {

struct Row {
  int code;
  std::string word;
  int status;
};

// The outcomes of doc/interface.md and the exit statuses of doc/command-line.md.
TEST(Outcome, EveryCodeHasItsWordAndExitStatus) {
  const std::vector<Row> table = {
      {0, "internal", 5},   {1, "plan_found", 0}, {50, "canceled", 4},  {51, "no_plan", 1},
      {52, "no_plan", 1},   {53, "undecided", 3}, {54, "undecided", 3}, {55, "undecided", 3},
      {60, "undecided", 3}, {61, "undecided", 3}, {62, "undecided", 3}, {63, "undecided", 3},
      {64, "undecided", 3}, {65, "undecided", 3}, {70, "invalid", 2},   {71, "invalid", 2},
      {72, "invalid", 2},   {73, "invalid", 2},   {80, "internal", 5}};
  for (const Row& row : table) {
    const auto code = static_cast<OutcomeCode>(row.code);
    EXPECT_EQ(outcomeWord(code), row.word) << row.code;
    EXPECT_EQ(exitStatus(code), row.status) << row.code;
  }
}

std::vector<int> codesWith(bool OutcomeTraits::*trait) {
  std::vector<int> codes;
  for (int code = 0; code < 100; ++code) {
    const OutcomeTraits& row = outcomeTraits(static_cast<OutcomeCode>(code));
    if (static_cast<int>(row.code) == code && row.*trait) codes.push_back(code);
  }
  return codes;
}

std::vector<int> codesWith(AlternativesFrom from) {
  std::vector<int> codes;
  for (int code = 0; code < 100; ++code) {
    const OutcomeTraits& row = outcomeTraits(static_cast<OutcomeCode>(code));
    if (static_cast<int>(row.code) == code && row.alternatives == from) codes.push_back(code);
  }
  return codes;
}

using Codes = std::vector<int>;

TEST(Outcome, EveryCodeHasItsTraits) {
  EXPECT_EQ(codesWith(&OutcomeTraits::resumable), (Codes{50, 53, 54, 55, 60, 61, 62, 64, 70, 73}));
  EXPECT_EQ(codesWith(&OutcomeTraits::rests_on_robot_state), (Codes{1, 51, 52}));
  EXPECT_EQ(codesWith(&OutcomeTraits::closes_journal), (Codes{0, 1, 51, 52, 63, 65, 71, 72}));
  EXPECT_EQ(codesWith(&OutcomeTraits::ended_on_request), (Codes{50, 61}));
  EXPECT_EQ(codesWith(AlternativesFrom::KnownPlans), (Codes{53, 54}));
  EXPECT_EQ(codesWith(AlternativesFrom::ShortSearch), (Codes{52, 55, 61, 62, 64}));
}

TEST(Outcome, ANumberThatIsNoCodeIsReadAsNone) {
  EXPECT_EQ(outcomeTraits(static_cast<OutcomeCode>(79)).code, OutcomeCode::None);
}

TEST(Outcome, OfALimit) {
  EXPECT_EQ(outcomeOf(LimitReason::Cancelled), OutcomeCode::Canceled);
  EXPECT_EQ(outcomeOf(LimitReason::Memory), OutcomeCode::MemoryLimit);
  EXPECT_EQ(outcomeOf(LimitReason::Time), OutcomeCode::TimeLimit);
  EXPECT_EQ(outcomeOf(LimitReason::States), OutcomeCode::BudgetLimit);
}

TEST(Outcome, OfAnException) {
  validation::Violation violation;
  violation.step = 4;
  violation.message = "step 5 (go): no";
  const Outcome invalid_plan = outcomeOf(alignment::HumanPlanInvalid(violation));
  EXPECT_EQ(invalid_plan.code, OutcomeCode::HumanPlanInvalid);
  EXPECT_EQ(invalid_plan.failing_step, 4);
  EXPECT_NE(invalid_plan.message.find("step 5 (go): no"), std::string::npos);
  EXPECT_EQ(outcomeOf(alignment::GoalNotExpected({}, "", false)).code,
            OutcomeCode::GoalNotExpected);
  EXPECT_EQ(outcomeOf(alignment::GoalsDiffer("two")).code, OutcomeCode::InvalidModel);
  EXPECT_EQ(outcomeOf(pddl::SyntaxError("f", {}, "m")).code, OutcomeCode::InvalidModel);
  EXPECT_EQ(outcomeOf(pddl::SemanticError("f", {}, "m")).code, OutcomeCode::InvalidModel);
  EXPECT_EQ(outcomeOf(pddl::UnsupportedError("f", {}, "m")).code, OutcomeCode::InvalidModel);
  EXPECT_EQ(outcomeOf(LimitReached(LimitReason::Memory, "it")).code, OutcomeCode::MemoryLimit);
  EXPECT_EQ(outcomeOf(std::bad_alloc()).code, OutcomeCode::MemoryLimit);
  EXPECT_EQ(outcomeOf(Exception("hm")).code, OutcomeCode::Internal);
  EXPECT_EQ(outcomeOf(std::logic_error("hm")).code, OutcomeCode::Internal);
  EXPECT_EQ(outcomeOf(std::logic_error("hm")).failing_step, -1);
}

}  // namespace
}  // namespace goal_alignment::session
