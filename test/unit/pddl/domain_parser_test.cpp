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
  ASSERT_TRUE(move.cost && move.cost->function);
  EXPECT_EQ(move.cost->function->terms.size(), 2U);
  EXPECT_EQ(domain.actions.at(0).cost->constant, 5);
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
  EXPECT_EQ(action(":effect (increase (total-cost) 5.0)").cost->constant, 5);
  EXPECT_EQ(action(":effect (increase (total-cost) 0)").cost->constant, 0);
  EXPECT_EQ(action(":effect (increase (total-cost) 1000000000)").cost->constant, 1000000000);
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
               "the '(' at 1:1 is still open"},
        Broken{kStart + "(:types a",
               "d.pddl:2:10: expected a type, '-' or ')', found the end of "
               "the text; the '(' at 2:1 is still open"},
        Broken{kStart + "))", "d.pddl:2:2: expected the end of the text, found ')'"},
        Broken{kStart + ") (define", "d.pddl:2:3: expected the end of the text, found '('"},
        Broken{kStart + "(:predicate (p)))",
               "d.pddl:2:2: expected a section of a domain, such as ':action', found ':predicate'; "
               "did you mean ':predicates'?"},
        Broken{kStart + "(:types a) (:Types b))",
               "d.pddl:2:13: ':Types' stands here a second time; the first is at 2:2"},
        Broken{kStart + "(:types - a))", "d.pddl:2:9: expected a type or ')', found '-'"},
        Broken{kStart + "(:types a - ))", "d.pddl:2:13: expected a type, found ')'"},
        Broken{kStart + "(:types a -b))", "d.pddl:2:11: expected a type, '-' or ')', found '-b'"},
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
               "d.pddl:2:38: expected '(' or ')', found ':effect'"},
        Broken{kStart + "(:action a :precondition (p (q))))",
               "d.pddl:2:29: expected a parameter, an object or ')', found '('"},
        Broken{kStart + "(:action a :precondition ((p))))",
               "d.pddl:2:27: expected a predicate, 'and', 'not' or ')', found '('"},
        Broken{kStart + "(:action a :precondition (not p)))",
               "d.pddl:2:31: expected a formula's '(', found 'p'"},
        Broken{kStart + "(:action a :precondition (not (p) (q))))",
               "d.pddl:2:35: expected ')', found '('"},
        Broken{kStart + "(:action a :precondition (= ?x)))",
               "d.pddl:2:27: expected two terms after '=', found 1"},
        Broken{kStart + "(:action a :precondition (increase (total-cost) 1)))",
               "d.pddl:2:27: expected a predicate, found 'increase'"},
        Broken{kStart + "(:action a :effect (= ?x ?y)))",
               "d.pddl:2:21: expected a predicate, 'and', 'not', 'increase' or ')', found '='"},
        Broken{kStart + "(:action a :effect (increase total-cost 1)))",
               "d.pddl:2:30: expected '(total-cost)', found 'total-cost'"},
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
