// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "goal_alignment/pddl/parser.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

using samples::problemError;

ast::Problem parse(const std::string& text) {
  return parseProblem({"p.pddl", text});
}

TEST(ProblemParser, ReadsEverySection) {
  const ast::Problem problem = parse(samples::kTeaProblem);
  EXPECT_EQ(problem.name.spelling, "two-cups");
  EXPECT_EQ(problem.domain_name.spelling, "tea");
  ASSERT_EQ(problem.objects.size(), 4U);
  EXPECT_EQ(problem.objects[2].type->spelling, "kettle");
  EXPECT_EQ(problem.init.size(), 4U);
  ASSERT_EQ(problem.init_values.size(), 3U);
  EXPECT_EQ(problem.init_values[1].value, 3);
  ASSERT_EQ(problem.goal.size(), 2U);
  EXPECT_TRUE(problem.goal[1].literal.negated);
  EXPECT_EQ(problem.goal_position.line, 6);
  EXPECT_EQ(problem.goal_position.column, 4);
  EXPECT_TRUE(problem.minimises_total_cost);
}

TEST(ProblemParser, DomainAndGoalAreEnough) {
  const ast::Problem problem = parse("(define (problem p) (:goal ()) (:domain d))");
  EXPECT_TRUE(problem.objects.empty() && problem.init.empty() && problem.goal.empty());
  EXPECT_FALSE(problem.minimises_total_cost);
}

TEST(ProblemParser, AcceptsEmptySectionsAndRequirements) {
  const ast::Problem problem = parse(
      "(define (problem p) (:domain d) (:requirements :strips) (:objects) (:init) (:goal (and)))");
  EXPECT_TRUE(problem.goal.empty());
}

TEST(ProblemParser, KeepsNegativeFactsApart) {
  const ast::Problem problem =
      parse("(define (problem p) (:domain d) (:init (a) (not (b)) (c)) (:goal (a)))");
  EXPECT_EQ(problem.init.size(), 2U);
  ASSERT_EQ(problem.init_false.size(), 1U);
  EXPECT_EQ(problem.init_false[0].predicate.spelling, "b");
}

TEST(ProblemParser, APredicateMayBeCalledAt) {
  const ast::Problem problem =
      parse("(define (problem p) (:domain d) (:init (at 5 home)) (:goal (at x 7)))");
  EXPECT_EQ(problem.init.at(0).terms.size(), 2U);
  EXPECT_EQ(problem.goal.at(0).literal.atom.terms.size(), 2U);
}

TEST(ProblemParser, FunctionsWithoutArgumentsMayStandBare) {
  const ast::Problem problem = parse(
      "(define (problem p) (:domain d) (:init (= total-cost 0) (= way 7)) (:goal (a)) "
      "(:metric minimize Total-Cost))");
  ASSERT_EQ(problem.init_values.size(), 2U);
  EXPECT_EQ(problem.init_values[1].function.predicate.spelling, "way");
  EXPECT_EQ(problem.init_values[1].value, 7);
  EXPECT_TRUE(problem.minimises_total_cost);
}

struct Broken {
  std::string text;
  std::string message;
};

void PrintTo(const Broken& broken, std::ostream* out) {
  *out << broken.text;
}

class BrokenProblem : public testing::TestWithParam<Broken> {};

TEST_P(BrokenProblem, SaysWhereAndWhatWasExpected) {
  EXPECT_EQ(problemError<SyntaxError>(GetParam().text), GetParam().message);
}

const std::string kStart = "(define (problem p) (:domain d)\n";

INSTANTIATE_TEST_SUITE_P(
    Texts, BrokenProblem,
    testing::Values(
        Broken{"(define (domain d))", "p.pddl:1:10: expected 'problem', found 'domain'"},
        Broken{"(define (problem p) (:goal (g)))", "p.pddl:1:32: expected (:domain …), found ')'"},
        Broken{kStart + "(:init (a)))", "p.pddl:2:12: expected (:goal …), found ')'"},
        Broken{kStart + "(:goal (g)",
               "p.pddl:2:11: expected ')', found the end of the text; the "
               "'(:goal' at 2:1 is still open"},
        Broken{kStart + "(:goal (g) (h)))",
               "p.pddl:2:12: expected ')', found '('; the '(:goal' at 2:1 is still open"},
        Broken{
            kStart + "(:goal (and (g)) (h)))",
            "p.pddl:2:18: expected ')', found '('; the ')' at 2:16 closes the '(and' at 2:8, and "
            "there may be one ')' too many"},
        Broken{kStart + "(:init (a) (b)\n(:goal (g)))",
               "p.pddl:3:2: expected a predicate, 'not' or '=', found ':goal'; the '(:init' at 2:1 "
               "is still open"},
        Broken{kStart + "(:init (a)) (b))\n(:goal (g)))",
               "p.pddl:2:14: expected a section of a problem, such as ':init', found 'b'; the ')' "
               "at 2:11 closes the '(:init' at 2:1, and there may be one ')' too many"},
        Broken{kStart + "(:init (a)))\n(:goal (g)))",
               "p.pddl:2:12: expected (:goal …), found ')'; the ')' at 2:12 closes the '(define' "
               "at 1:1, and there may be one ')' too many"},
        Broken{kStart + "(:goal g))", "p.pddl:2:8: expected '(', found 'g'"},
        Broken{kStart + "(:goal (g ?x)))", "p.pddl:2:11: expected an object or ')', found '?x'"},
        Broken{kStart + "(:objcts a))",
               "p.pddl:2:2: expected a section of a problem, such as ':init', found ':objcts'; did "
               "you mean ':objects'?"},
        Broken{kStart + "(:init a))", "p.pddl:2:8: expected '(' or ')', found 'a'"},
        Broken{kStart + "(:init ()))", "p.pddl:2:9: expected a predicate, 'not' or '=', found ')'"},
        Broken{kStart + "(:init (not (not (a)))))",
               "p.pddl:2:14: expected a predicate, found 'not'"},
        Broken{kStart + "(:init (= (f a) -1)))",
               "p.pddl:2:17: expected a non-negative whole number, found '-1'"},
        Broken{kStart + "(:init (= (f a))))",
               "p.pddl:2:16: expected a non-negative whole number, found ')'"},
        Broken{kStart + "(:init (= ?f 1)))", "p.pddl:2:11: expected a function's '(', found '?f'"},
        Broken{kStart + "(:metric total-cost))",
               "p.pddl:2:10: expected 'minimize', found "
               "'total-cost'"},
        Broken{kStart + "(:metric minimize))", "p.pddl:2:18: expected '(total-cost)', found ')'"},
        Broken{kStart + "(:init) (:goal ()) (:init))",
               "p.pddl:2:21: ':init' stands here a second time; the first is at 2:2"}));

}  // namespace
}  // namespace goal_alignment::pddl
