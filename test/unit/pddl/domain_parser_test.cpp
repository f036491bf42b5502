// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "goal_alignment/pddl/parser.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

using samples::domainError;
using samples::kTeaDomain;

ast::Domain parse(const std::string& text) {
  return parseDomain({"d.pddl", text});
}

samples::Held<ast::Action> action(const std::string& body) {
  const ast::Domain domain = parse("(define (domain d) (:action a " + body + "))");
  return samples::held(domain.actions.at(0), domain.source);
}

TEST(DomainParser, ReadsEverySection) {
  const ast::Domain domain = parse(kTeaDomain);
  EXPECT_EQ(domain.source->name, "d.pddl");
  EXPECT_EQ(domain.name.spelling, "Tea");
  EXPECT_EQ(domain.requirements.size(), 2U);
  ASSERT_EQ(domain.types.size(), 4U);
  EXPECT_EQ(domain.types[1].name.spelling, "kettle");
  EXPECT_EQ(domain.types[0].type->spelling, "vessel");
  EXPECT_FALSE(domain.types[3].type);
  ASSERT_EQ(domain.constants.size(), 1U);
  EXPECT_EQ(domain.constants[0].name.spelling, "Table");
  ASSERT_EQ(domain.predicates.size(), 4U);
  EXPECT_EQ(domain.predicates[0].parameters.at(1).name.spelling, "?p");
  ASSERT_EQ(domain.functions.size(), 2U);
  ASSERT_EQ(domain.actions.size(), 3U);
}

TEST(DomainParser, ReadsAnAction) {
  const ast::Domain domain = parse(kTeaDomain);
  const ast::Action& move = domain.actions.at(2);
  ASSERT_EQ(move.parameters.size(), 3U);
  EXPECT_EQ(move.parameters[1].type->spelling, "place");
  ASSERT_EQ(move.precondition.size(), 3U);
  EXPECT_EQ(move.precondition[0].literal.atom.predicate.spelling, "HandEmpty");
  EXPECT_TRUE(move.precondition[2].literal.equality);
  EXPECT_TRUE(move.precondition[2].literal.negated);
  ASSERT_EQ(move.effect.size(), 2U);
  EXPECT_TRUE(move.effect[0].negated);
  ASSERT_EQ(move.costs.size(), 1U);
  ASSERT_TRUE(move.costs[0].function);
  EXPECT_EQ(move.costs[0].function->terms.size(), 2U);
  EXPECT_EQ(domain.actions.at(0).costs.at(0).constant, 5);
}

TEST(DomainParser, ABareDomainIsEnough) {
  const ast::Domain domain = parse("(define (domain d))");
  EXPECT_TRUE(domain.predicates.empty() && domain.actions.empty() && domain.types.empty());
}

TEST(DomainParser, SectionsComeInAnyOrderAndAnyCase) {
  const ast::Domain domain = parse(
      "(DEFINE (Domain d) (:Action a :EFFECT (p) :parameters ()) (:PREDICATES (p)) "
      "(:requirements))");
  EXPECT_EQ(domain.predicates.size(), 1U);
  EXPECT_EQ(domain.actions.at(0).effect.size(), 1U);
}

TEST(DomainParser, CommentsTabsAndLineEndsDoNotCount) {
  std::string crlf;
  for (const char c : kTeaDomain)
    crlf += c == '\n' ? "\t; note ( here\r\n" : std::string(1, c);
  const ast::Domain domain = parse(crlf);
  EXPECT_EQ(domain.actions.size(), 3U);
  EXPECT_EQ(domain.actions[2].name.position.line, parse(kTeaDomain).actions[2].name.position.line);
}

TEST(DomainParser, ATrueConditionHasManyForms) {
  for (const char* body : {"", ":precondition ()", ":precondition (and)",
                           ":precondition (and (and) ())", ":parameters () :effect ()"}) {
    EXPECT_TRUE(action(body).precondition.empty()) << body;
    EXPECT_TRUE(action(body).effect.empty()) << body;
  }
}

TEST(DomainParser, ConjunctionsAreFlattened) {
  const auto nested =
      action(":precondition (and (p) (and (q) (and (not (r)))) (s)) :effect (and (and (p)) (q))");
  ASSERT_EQ(nested.precondition.size(), 4U);
  EXPECT_TRUE(nested.precondition[2].literal.negated);
  EXPECT_EQ(nested.precondition[3].literal.atom.predicate.spelling, "s");
  EXPECT_EQ(nested.effect.size(), 2U);
  EXPECT_EQ(action(":precondition (p) :effect (not (p))").precondition.size(), 1U);
}

TEST(DomainParser, AcceptsEveryRequirementFlag) {
  EXPECT_EQ(parse("(define (domain d) (:requirements :adl :foo :conditional-effects))")
                .requirements.size(),
            3U);
  EXPECT_EQ(domainError<SyntaxError>("(define (domain d) (:requirements strips))"),
            "d.pddl:1:35: expected a requirement such as ':strips' or ')', found 'strips'");
}

TEST(DomainParser, WholeNumbersMayHaveAPoint) {
  const auto cost = [](const std::string& number) {
    return action(":effect (increase (total-cost) " + number + ")").costs.at(0).constant;
  };
  EXPECT_EQ(cost("5.0"), 5);
  EXPECT_EQ(cost("0"), 0);
  EXPECT_EQ(cost("1000000000"), 1000000000);
}

TEST(DomainParser, AnActionMayHaveSeveralCosts) {
  const auto costly = action(
      ":effect (and (increase (total-cost) 3) (p) (and (increase (total-cost) (f))) "
      "(increase (total-cost) 4))");
  ASSERT_EQ(costly.costs.size(), 3U);
  EXPECT_EQ(costly.costs[1].function->predicate.spelling, "f");
  EXPECT_EQ(costly.costs[2].constant, 4);
}

TEST(DomainParser, FunctionsWithoutArgumentsMayStandBare) {
  const auto bare = action(":effect (and (increase total-cost 3) (increase (Total-Cost) way))");
  ASSERT_EQ(bare.costs.size(), 2U);
  EXPECT_EQ(bare.costs[0].constant, 3);
  EXPECT_EQ(bare.costs[1].function->predicate.spelling, "way");
  EXPECT_TRUE(bare.costs[1].function->terms.empty());
}

TEST(DomainParser, ADashMayBeGluedToItsType) {
  const ast::Domain domain = parse(
      "(define (domain d) (:types cup -thing box) (:constants a b -cup c -(either cup box))"
      "(:predicates (in ?x -cup\t?y\r\n-box)) (:functions (f ?x -box) -number))");
  ASSERT_EQ(domain.types.size(), 2U);
  EXPECT_EQ(domain.types[0].type->spelling, "thing");
  EXPECT_EQ(domain.types[0].type->position.column, 33);
  ASSERT_EQ(domain.constants.size(), 3U);
  EXPECT_EQ(domain.constants[0].type->spelling, "cup");
  EXPECT_EQ(domain.constants[2].type->either.size(), 2U);
  EXPECT_EQ(domain.predicates.at(0).parameters.at(1).type->spelling, "box");
}

struct Broken {
  std::string text;
  std::string message;
};

void PrintTo(const Broken& broken, std::ostream* out) {
  *out << broken.text;
}

class BrokenDomain : public testing::TestWithParam<Broken> {};

TEST_P(BrokenDomain, SaysWhereAndWhatWasExpected) {
  EXPECT_EQ(domainError<SyntaxError>(GetParam().text), GetParam().message);
}

const std::string kStart = "(define (domain d)\n";

INSTANTIATE_TEST_SUITE_P(
    Texts, BrokenDomain,
    testing::Values(
        Broken{"", "d.pddl:1:1: expected '(define', found the end of the text"},
        Broken{"; nothing\n", "d.pddl:2:1: expected '(define', found the end of the text"},
        Broken{"define", "d.pddl:1:1: expected '(define', found 'define'"},
        Broken{"(domain d)", "d.pddl:1:2: expected 'define', found 'domain'"},
        Broken{"(define (problem p))", "d.pddl:1:10: expected 'domain', found 'problem'"},
        Broken{"(define (domain))", "d.pddl:1:16: expected the domain's name, found ')'"},
        Broken{"(define (domain d e))", "d.pddl:1:19: expected ')', found 'e'"},
        Broken{kStart + "foo)", "d.pddl:2:1: expected '(' or ')', found 'foo'"},
        Broken{kStart + "(:types a)",
               "d.pddl:2:11: expected '(' or ')', found the end of the text; "
               "the '(define' at 1:1 is still open"},
        Broken{kStart + "(:types a",
               "d.pddl:2:10: expected a type, '-' or ')', found the end of "
               "the text; the '(:types' at 2:1 is still open"},
        Broken{kStart + "))",
               "d.pddl:2:2: expected the end of the text, found ')'; the ')' at 2:1 closes the "
               "'(define' at 1:1, and there may be one ')' too many"},
        Broken{kStart + ") (define",
               "d.pddl:2:3: expected the end of the text, found '('; the ')' at 2:1 closes the "
               "'(define' at 1:1, and there may be one ')' too many"},
        Broken{kStart + "(:predicate (p)))",
               "d.pddl:2:2: expected a section of a domain, such as ':action', found ':predicate'; "
               "did you mean ':predicates'?"},
        Broken{kStart + "(:types a) (:Types b))",
               "d.pddl:2:13: ':Types' stands here a second time; the first is at 2:2"},
        Broken{kStart + "(:types - a))", "d.pddl:2:9: expected a type or ')', found '-'"},
        Broken{kStart + "(:types a - ))", "d.pddl:2:13: expected a type, found ')'"},
        Broken{kStart + "(:types -b))", "d.pddl:2:9: expected a type or ')', found '-b'"},
        Broken{kStart + "(:types a --b))", "d.pddl:2:12: expected a type, found '-b'"},
        Broken{kStart + "(:constants ?a))", "d.pddl:2:13: expected an object or ')', found '?a'"},
        Broken{kStart + "(:predicates p))", "d.pddl:2:14: expected '(' or ')', found 'p'"},
        Broken{kStart + "(:predicates (p x)))",
               "d.pddl:2:17: expected a variable such as '?x' or ')', found 'x'"},
        Broken{kStart + "(:predicates (p ?)))",
               "d.pddl:2:17: expected a variable such as '?x' or ')', found '?'"},
        Broken{kStart + "(:predicates (and ?x)))",
               "d.pddl:2:15: expected a predicate's name, found 'and', which PDDL reserves"},
        Broken{kStart + "(:predicates (= ?x ?y)))",
               "d.pddl:2:15: expected a predicate's name, found '='"}));

/// One bracket too few or too many shows where the text goes on as if there were none.
INSTANTIATE_TEST_SUITE_P(
    Brackets, BrokenDomain,
    testing::Values(
        Broken{
            kStart + "(:predicates (p)\n(:action a))",
            "d.pddl:3:2: expected a predicate's name, found ':action'; the '(:predicates' at 2:1 "
            "is still open"},
        Broken{kStart + "(:types a\n(:predicates (p)))",
               "d.pddl:3:1: expected a type, '-' or ')', found '('; the '(:types' at 2:1 is still "
               "open"},
        Broken{kStart + "(:action a :parameters (?x\n:effect (p)))",
               "d.pddl:3:1: expected a parameter such as '?x', '-' or ')', found ':effect'; the "
               "'(?x' at "
               "2:24 is still open"},
        Broken{kStart + "(:Action a :effect (and (p) (q))\n(:action b))",
               "d.pddl:3:1: expected ':parameters', ':precondition', ':effect' or ')', found '('; "
               "the '(:Action a' at 2:1 is still open"},
        Broken{kStart + "(:action a :effect (and (p) (not (q)\n(:action b))",
               "d.pddl:3:1: expected ')', found '('; the '(not' at 2:29 is still open"},
        Broken{kStart + "(:action a :precondition (and (p)))\n:effect (q)))",
               "d.pddl:3:1: expected '(' or ')', found ':effect'; the ')' at 2:35 closes the "
               "'(:action a' at 2:1, and there may be one ')' too many"},
        Broken{kStart + "(:action a :precondition (and (p))) ; done\n(q))",
               "d.pddl:3:2: expected a section of a domain, such as ':action', found 'q'; the ')' "
               "at 2:35 closes the '(:action a' at 2:1, and there may be one ')' too many"},
        Broken{kStart + "(:action a :precondition (and (p)) (q) :effect (p)))",
               "d.pddl:2:36: expected ':parameters', ':precondition', ':effect' or ')', found '('; "
               "the ')' at 2:34 closes the '(and' at 2:26, and there may be one ')' too many"},
        Broken{kStart + "(:types a)) (:action b))",
               "d.pddl:2:13: expected the end of the text, found '('; the ')' at 2:11 closes the "
               "'(define' at 1:1, and there may be one ')' too many"}));

INSTANTIATE_TEST_SUITE_P(
    Actions, BrokenDomain,
    testing::Values(
        Broken{kStart + "(:action))", "d.pddl:2:9: expected the action's name, found ')'"},
        Broken{kStart + "(:action a :precond (p)))",
               "d.pddl:2:12: expected ':parameters', ':precondition', ':effect' or ')', found "
               "':precond'"},
        Broken{kStart + "(:action a :efect (p)))",
               "d.pddl:2:12: expected ':parameters', ':precondition', ':effect' or ')', found "
               "':efect'; did you mean ':effect'?"},
        Broken{kStart + "(:action a :effect (p) :effect (q)))",
               "d.pddl:2:24: ':effect' stands here a second time; the first is at 2:12"},
        Broken{kStart + "(:action a :parameters ?x))", "d.pddl:2:24: expected '(', found '?x'"},
        Broken{kStart + "(:action a :parameters (x)))",
               "d.pddl:2:25: expected a parameter such as '?x' or ')', found 'x'"},
        Broken{kStart + "(:action a :precondition p))", "d.pddl:2:26: expected '(', found 'p'"},
        Broken{kStart + "(:action a :precondition (and p)))",
               "d.pddl:2:31: expected '(' or ')', found 'p'"},
        Broken{kStart + "(:action a :precondition (and (p ?x) :effect (q)))",
               "d.pddl:2:38: expected '(' or ')', found ':effect'; the '(and' at 2:26 is still "
               "open"},
        Broken{kStart + "(:action a :precondition (p (q))))",
               "d.pddl:2:29: expected a parameter, an object or ')', found '('; the '(p' at 2:26 "
               "is still open"},
        Broken{kStart + "(:action a :precondition ((p))))",
               "d.pddl:2:27: expected a predicate, 'and', 'not' or ')', found '('"},
        Broken{kStart + "(:action a :precondition (not p)))",
               "d.pddl:2:31: expected a formula's '(', found 'p'"},
        Broken{kStart + "(:action a :precondition (not (p) (q))))",
               "d.pddl:2:35: expected ')', found '('; the '(not' at 2:26 is still open"},
        Broken{kStart + "(:action a :precondition (= ?x)))",
               "d.pddl:2:27: expected two terms after '=', found 1"},
        Broken{kStart + "(:action a :precondition (increase (total-cost) 1)))",
               "d.pddl:2:27: expected a predicate, found 'increase'"},
        Broken{kStart + "(:action a :effect (= ?x ?y)))",
               "d.pddl:2:21: expected a predicate, 'and', 'not', 'increase' or ')', found '='"},
        Broken{kStart + "(:action a :effect (increase (total-cost) -1)))",
               "d.pddl:2:43: expected a non-negative whole number, found '-1'"},
        Broken{kStart + "(:action a :effect (increase (total-cost) 1x)))",
               "d.pddl:2:43: expected a non-negative whole number, found '1x'"},
        Broken{kStart + "(:action a :effect (increase (total-cost) .)))",
               "d.pddl:2:43: expected a non-negative whole number, found '.'"},
        Broken{kStart + "(:action a :effect (increase (total-cost))))",
               "d.pddl:2:42: expected a non-negative whole number, found ')'"},
        Broken{kStart + "(:action a :effect (increase (total-cost) 1000000001)))",
               "d.pddl:2:43: the number '1000000001' is too large; at most 1000000000"},
        Broken{kStart + "(:action a :effect (increase (total-cost) 99999999999999999999)))",
               "d.pddl:2:43: the number '99999999999999999999' is too large; at most "
               "1000000000"}));

}  // namespace
}  // namespace goal_alignment::pddl
