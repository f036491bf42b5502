// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "goal_alignment/pddl/parser.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

std::string planError(const std::string& text) {
  return samples::errorOf<SyntaxError>([&] { parsePlan({"plan", text}); });
}

TEST(PlanParser, ReadsOneActionALine) {
  const PlanText plan =
      parsePlan({"plan", "; a plan\n(pick-up A)\r\n\n  (STACK a b) ; up\n; cost = 2"});
  EXPECT_EQ(plan.source_name, "plan");
  ASSERT_EQ(plan.steps.size(), 2U);
  EXPECT_EQ(plan.steps[0].text(), "(pick-up a)");
  EXPECT_EQ(plan.steps[1].text(), "(stack a b)");
  ASSERT_EQ(plan.positions.size(), 2U);
  EXPECT_EQ(plan.positions[1].line, 4);
  EXPECT_EQ(plan.positions[1].column, 3);
}

TEST(PlanParser, AnEmptyPlanIsAPlan) {
  EXPECT_TRUE(parsePlan({"plan", ""}).steps.empty());
  EXPECT_TRUE(parsePlan({"plan", "\n; cost = 0 (unit cost)\n"}).steps.empty());
}

TEST(PlanParser, SkipsTimesAndDurations) {
  const PlanText plan = parsePlan({"plan", "0: (a x)\n0.00100: (b) [1]\n2:(c)[1.000]\n"});
  ASSERT_EQ(plan.steps.size(), 3U);
  EXPECT_EQ(plan.steps[0].text(), "(a x)");
  EXPECT_EQ(plan.steps[2].text(), "(c)");
}

TEST(PlanParser, AnActionMayBeNamedLikeAFormula) {
  EXPECT_EQ(parsePlan({"plan", "(increase x)"}).steps.at(0).name, "increase");
}

TEST(PlanParser, SaysWhereALineIsBroken) {
  EXPECT_EQ(planError("(a)\nstack a b\n"), "plan:2:1: expected an action's '(', found 'stack'");
  EXPECT_EQ(planError("(a)\n(b x\n"),
            "plan:3:1: expected an object or ')', found the end of the text; the '(' at 2:1 is "
            "still open");
  EXPECT_EQ(planError("()"), "plan:1:2: expected an action's name, found ')'");
  EXPECT_EQ(planError("(a ?x)"), "plan:1:4: expected an object or ')', found '?x'");
  EXPECT_EQ(planError("(a (b))"), "plan:1:4: expected an object or ')', found '('");
  EXPECT_EQ(planError("(a))"), "plan:1:4: expected an action's '(', found ')'");
  EXPECT_EQ(planError("x: (a)"), "plan:1:1: expected an action's '(', found 'x:'");
}

TEST(LiteralsParser, ReadsAtomsAndNegations) {
  const std::vector<Literal> literals =
      parseLiterals({"goal", "; wanted\n(on A b)\n(NOT (clear c))\n(handempty)\n"});
  ASSERT_EQ(literals.size(), 3U);
  EXPECT_EQ(literals[0].text(), "(on a b)");
  EXPECT_EQ(literals[1].text(), "(not (clear c))");
  EXPECT_EQ(literals[2].text(), "(handempty)");
  EXPECT_TRUE(parseLiterals({"goal", ""}).empty());
}

TEST(LiteralsParser, SaysWhereALineIsBroken) {
  const auto error = [](const std::string& text) {
    return samples::errorOf<SyntaxError>([&] { parseLiterals({"goal", text}); });
  };
  EXPECT_EQ(error("on a b"), "goal:1:1: expected a literal's '(', found 'on'");
  EXPECT_EQ(error("(not p)"), "goal:1:6: expected an atom's '(', found 'p'");
  EXPECT_EQ(error("(and (p))"), "goal:1:2: expected a predicate, found 'and'");
  EXPECT_EQ(error("(or (p))"), "goal:1:2: expected a predicate, found 'or'");
}

}  // namespace
}  // namespace goal_alignment::pddl
