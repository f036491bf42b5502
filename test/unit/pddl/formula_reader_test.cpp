// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "goal_alignment/pddl/parser.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

using Kind = ast::Formula::Kind;

using samples::held;
using samples::Held;

Held<ast::Action> action(const std::string& body) {
  const ast::Domain domain =
      parseDomain({"d.pddl", "(define (domain d) (:action a " + body + "))"});
  return held(domain.actions.at(0), domain.source);
}

Held<ast::Formula> precondition(const std::string& text) {
  const auto read = action(":precondition " + text);
  return held(read.precondition.at(0), read.source);
}

TEST(FormulaReader, ReadsEveryConnective) {
  const auto either = precondition("(or (p) (not (q)) (and (p) (q)))");
  EXPECT_EQ(either.kind, Kind::Or);
  ASSERT_EQ(either.parts.size(), 3U);
  EXPECT_TRUE(either.parts[1].literal.negated);
  EXPECT_EQ(either.parts[2].kind, Kind::And);
  EXPECT_EQ(precondition("(imply (p) (q))").parts.size(), 2U);
  EXPECT_EQ(precondition("(not (or (p)))").kind, Kind::Not);
  EXPECT_EQ(precondition("(not (not (p)))").parts.at(0).literal.negated, true);
  EXPECT_TRUE(precondition("(or)").parts.empty());
}

TEST(FormulaReader, ReadsQuantifiers) {
  const auto all = precondition("(forall (?x ?y - t) (exists (?z - (either t u)) (p ?z)))");
  EXPECT_EQ(all.kind, Kind::ForAll);
  ASSERT_EQ(all.variables.size(), 2U);
  EXPECT_EQ(all.variables[0].type->spelling, "t");
  const ast::Formula& some = all.parts.at(0);
  EXPECT_EQ(some.kind, Kind::Exists);
  ASSERT_EQ(some.variables.at(0).type->either.size(), 2U);
  EXPECT_EQ(some.variables[0].type->either[1].spelling, "u");
}

TEST(FormulaReader, OnlyBelowAQuantifierAGoalHasVariables) {
  const std::string problem = "(define (problem p) (:domain d) (:goal ";
  EXPECT_EQ(parseProblem({"p.pddl", problem + "(forall (?x) (p ?x a))))"}).goal.size(), 1U);
  EXPECT_EQ(samples::problemError<SyntaxError>(problem + "(or (p ?x))))"),
            "p.pddl:1:47: expected an object or ')', found '?x'");
}

TEST(FormulaReader, EffectsKeepTheirNesting) {
  const auto read =
      action(":effect (and (p) (forall (?x) (and (q ?x) (when (p) (not (q ?x))))) (when () (r)))");
  EXPECT_EQ(read.effect.size(), 1U);
  ASSERT_EQ(read.conditional.size(), 2U);
  const ast::ConditionalEffect& all = read.conditional[0];
  EXPECT_EQ(all.variables.size(), 1U);
  EXPECT_EQ(all.literals.size(), 1U);
  ASSERT_EQ(all.nested.size(), 1U);
  EXPECT_EQ(all.nested[0].condition.size(), 1U);
  EXPECT_TRUE(all.nested[0].literals.at(0).negated);
  EXPECT_TRUE(read.conditional[1].condition.empty());
}

TEST(FormulaReader, SaysWhatIsMissing) {
  const auto error = [](const std::string& body) {
    return samples::domainError<SyntaxError>("(define (domain d) (:action a\n" + body + "))");
  };
  EXPECT_EQ(error(":precondition (imply (p))"), "d.pddl:2:25: expected '(', found ')'");
  EXPECT_EQ(error(":precondition (imply (p) (q) (r))"),
            "d.pddl:2:30: expected ')', found '('; the '(imply' at 2:15 is still open");
  EXPECT_EQ(error(":precondition (forall ?x (p))"), "d.pddl:2:23: expected '(', found '?x'");
  EXPECT_EQ(error(":precondition (exists (x) (p))"),
            "d.pddl:2:24: expected a variable such as '?x' or ')', found 'x'");
  EXPECT_EQ(error(":precondition (exists (?x))"), "d.pddl:2:27: expected '(', found ')'");
  EXPECT_EQ(error(":precondition (not)"), "d.pddl:2:19: expected a formula's '(', found ')'");
  EXPECT_EQ(error(":precondition (when (p) (q))"),
            "d.pddl:2:16: expected a predicate, found 'when'");
  EXPECT_EQ(error(":effect (when (p))"), "d.pddl:2:18: expected an effect's '(', found ')'");
  EXPECT_EQ(error(":effect (or (p) (q))"), "d.pddl:2:10: expected a predicate, found 'or'");
  EXPECT_EQ(error(":effect (when (p) (q) (r))"),
            "d.pddl:2:23: expected ')', found '('; the '(when' at 2:9 is still open");
  EXPECT_EQ(error(":parameters (?x - (either))"), "d.pddl:2:26: expected a type, found ')'");
  EXPECT_EQ(error(":parameters (?x - (or a b))"), "d.pddl:2:20: expected 'either', found 'or'");
}

}  // namespace
}  // namespace goal_alignment::pddl
