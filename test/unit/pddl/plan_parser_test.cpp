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

/// The steps in a row.
std::string steps(const std::string& text) {
  std::string all;
  for (const GroundName& step : parsePlan({"plan", text}).steps)
    all += step.text();
  return all;
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

TEST(PlanParser, TimesAndDurationsHaveManyForms) {
  EXPECT_EQ(steps("0.0003:   (WALK A B) [1.0000]\r\n1e-3 : (go) [D:1.00; C:0.10]\r\n\t12:(c)"),
            "(walk a b)(go)(c)");
  EXPECT_EQ(steps("1. (walk a b)\n2.\t(go)\n"), "(walk a b)(go)");
  EXPECT_EQ(steps("0.000: walk(a, b) [1.000]"), "(walk a b)");
}

TEST(PlanParser, ReadsCallsWithCommas) {
  EXPECT_EQ(steps("walk(a, b)\nWalk(A,B) ; on\n  go( c )\r\nwait()\tstep(x)"),
            "(walk a b)(walk a b)(go c)(wait)(step x)");
  EXPECT_EQ(steps("walk(a,\n     b)"), "(walk a b)");
  EXPECT_EQ(steps("gehe(küche, büro)"), "(gehe küche büro)");
  EXPECT_EQ(steps("(walk a,b)"), "(walk a,b)") << "in PDDL's own form a comma is a letter";
  const PlanText plan = parsePlan({"plan", "\n 3: walk(a, b)"});
  EXPECT_EQ(plan.positions.at(0).line, 2);
  EXPECT_EQ(plan.positions.at(0).column, 5);
}

const std::string kFastForward =
    "\nff: parsing domain file\ndomain 'LOBBY' defined\n ... done.\nff: parsing problem file\n"
    "problem 'P' defined\n ... done.\n\n\n\n"
    "Cueing down from goal distance:    2 into depth [1]\n"
    "                                   1            [1]\n"
    "                                   0            \n\n"
    "ff: found legal plan as follows\n\n"
    "step    0: WALK REX HALL KITCHEN\n        1: WAIT\n       10: GREET REX ANN\n     \n\n"
    "time spent:    0.00 seconds instantiating 2 easy, 0 hard action templates\n"
    "               0.00 seconds searching, evaluating 3 states, to a max depth of 1\n"
    "               0.00 seconds total time\n\n";

TEST(PlanParser, ReadsWhatFastForwardPrints) {
  const std::string plan = "(walk rex hall kitchen)(wait)(greet rex ann)";
  EXPECT_EQ(steps(kFastForward), plan);
  std::string windows;
  for (const char c : kFastForward)
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(steps(windows), plan);
  EXPECT_EQ(steps(samples::with(kFastForward, "\ntime", "plan cost: 3.000000\n\ntime")), plan);
  EXPECT_EQ(parsePlan({"plan", kFastForward}).positions.at(2).line, 19);
}

TEST(PlanParser, ReadsFastForwardsStepsAlone) {
  EXPECT_EQ(steps("step    0: WALK A B\n        1: GO B ; home\n"), "(walk a b)(go b)");
  EXPECT_EQ(steps("Step 0 : walk a b\n1:GO B\n2: step c"), "(walk a b)(go b)(step c)");
  EXPECT_EQ(steps("0: WALK A B [1]\n1: WALK (A, B)"), "(walk a b)(walk a b)");
}

TEST(PlanParser, NoStepIsTakenForChatter) {
  EXPECT_EQ(steps("(go a)\nnote\nff: found legal plan as follows\nstep 0: GO B\n"), "(go a)(go b)");
  EXPECT_EQ(planError("(go a)\n0.00 seconds total time"),
            "plan:2:6: expected ':' behind the step's number, found 'seconds'");
  EXPECT_EQ(planError("ff: parsing domain file\n"),
            "plan:1:1: expected an action such as '(go a b)' or 'go(a, b)', found 'ff:'");
  EXPECT_EQ(planError(kFastForward + "and so on"),
            "plan:26:1: expected an action such as '(go a b)' or 'go(a, b)', found 'and'");
}

TEST(PlanParser, ASingleStepNeedsNoBrackets) {
  const auto step = [](const std::string& text) { return parseStep({"step", text}).text(); };
  for (const char* text :
       {"(go a B)", "go A b", "go(a, b)", " GO(a,b)\n", "3: go a b", "(go a b) [1]"})
    EXPECT_EQ(step(text), "(go a b)") << text;
  const auto error = [&](const std::string& text) {
    return samples::errorOf<SyntaxError>([&] { step(text); });
  };
  EXPECT_EQ(error("(go a) (go b)"), "step:1:8: expected the end of the text, found '('");
  EXPECT_EQ(error("go(a"),
            "step:1:5: expected an object or ')', found the end of the text; the '(a' "
            "at 1:3 is still open");
  EXPECT_EQ(error(""),
            "step:1:1: expected an action such as '(go a b)' or 'go(a, b)', found the end "
            "of the text");
}

TEST(PlanParser, AnActionMayBeNamedLikeAFormula) {
  EXPECT_EQ(parsePlan({"plan", "(increase x)"}).steps.at(0).name, "increase");
}

TEST(PlanParser, SaysWhereALineIsBroken) {
  const std::string action = "expected an action such as '(go a b)' or 'go(a, b)', found ";
  EXPECT_EQ(planError("(a)\nstack a b\n"), "plan:2:1: " + action + "'stack'");
  EXPECT_EQ(planError("Plan: (go a)"), "plan:1:1: " + action + "'Plan:'");
  EXPECT_EQ(planError("stack (a)"), "plan:1:1: " + action + "'stack'");
  EXPECT_EQ(planError("(a) [soon]"), "plan:1:5: " + action + "'[soon]'");
  EXPECT_EQ(planError("go(a,,b)"), "plan:1:6: expected an object, found ',b'");
  EXPECT_EQ(planError("go(,a)"), "plan:1:4: expected an object or ')', found ',a'");
  EXPECT_EQ(planError("go(a,)"), "plan:1:6: expected an object, found ')'");
  EXPECT_EQ(planError("3 (a)"), "plan:1:3: expected ':' behind the step's number, found '('");
  EXPECT_EQ(planError("(a)\n(b x\n"),
            "plan:3:1: expected an object or ')', found the end of the text; the '(b' at 2:1 "
            "is still open");
  EXPECT_EQ(planError("()"), "plan:1:2: expected an action's name, found ')'");
  EXPECT_EQ(planError("(a ?x)"), "plan:1:4: expected an object or ')', found '?x'");
  EXPECT_EQ(planError("(a (b))"), "plan:1:4: expected an object or ')', found '('");
  EXPECT_EQ(planError("(a))"),
            "plan:1:4: " + action +
                "')'; the ')' at 1:3 closes the '(a' at 1:1, and there may be one ')' too many");
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
