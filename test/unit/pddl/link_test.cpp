// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "goal_alignment/pddl/model.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

using samples::kTeaDomain;
using samples::kTeaProblem;
using samples::linkError;
using samples::with;

Model linked(const std::string& domain_body, const std::string& problem_body) {
  return readModel({"d.pddl", "(define (domain d) " + domain_body + ")"},
                   {"p.pddl", "(define (problem p) (:domain d) (:goal ()) " + problem_body + ")"});
}

/// The fault after `d.pddl:2:`, where the body stands on line 2 of the domain.
std::string domainFault(const std::string& body) {
  return linkError("(define (domain d)\n" + body + ")",
                   "(define (problem p) (:domain d) (:goal ()))");
}

TEST(Link, ResolvesTheTeaTask) {
  const Model model = samples::tea();
  EXPECT_EQ(model.types.size(), 5U);
  EXPECT_EQ(model.types[kObjectType].name.name, "object");
  EXPECT_EQ(model.objects.size(), 5U);
  EXPECT_EQ(model.objects[0].name.spelling, "Table") << "constants come first";
  EXPECT_EQ(model.functions.size(), 1U) << "total-cost is none";
  EXPECT_EQ(model.init.size(), 4U);
  EXPECT_EQ(model.function_values.size(), 2U);
  EXPECT_TRUE(model.has_costs);
  ASSERT_EQ(model.schemas.size(), 3U);
  EXPECT_EQ(model.schemas[2].equalities.size(), 1U);
  EXPECT_TRUE(model.schemas[2].equalities[0].negated);
  EXPECT_EQ(model.schemas[2].function_costs.size(), 1U);
  EXPECT_EQ(model.schemas[0].constant_cost, 5);
  EXPECT_FALSE(model.schemas[0].precondition[0].atom.terms[1].is_parameter);
  EXPECT_EQ(model.schemas[0].name.name, "heat");
  EXPECT_EQ(model.schemas[0].name.spelling, "Heat");
}

TEST(Link, KnowsWhichPredicatesActionsChange) {
  const Model model = samples::tea();
  EXPECT_TRUE(model.predicates[*model.findPredicate("at")].fluent);
  EXPECT_TRUE(model.predicates[*model.findPredicate("hot")].fluent);
  EXPECT_FALSE(model.predicates[*model.findPredicate("handempty")].fluent);
}

TEST(Link, UntypedDomainsHaveObjectsOnly) {
  const Model model = linked("(:predicates (p ?x) (q)) (:action a :parameters (?x) :effect (p ?x))",
                             "(:objects a b) (:init (q) (p a))");
  EXPECT_EQ(model.types.size(), 1U);
  EXPECT_EQ(model.objects.at(1).type, kObjectType);
  EXPECT_EQ(model.init.size(), 2U);
  EXPECT_FALSE(model.has_costs);
}

TEST(Link, DuplicateFactsCountOnce) {
  EXPECT_EQ(linked("(:predicates (p ?x))", "(:objects a) (:init (p a) (P A))").init.size(), 1U);
}

TEST(Link, AFactThatIsFalseAnywayMayBeSaid) {
  EXPECT_TRUE(linked("(:predicates (p))", "(:init (not (p)))").init.empty());
}

TEST(Link, AParentTypeNeedsNoDeclarationOfItsOwn) {
  const Model model = linked("(:types truck - vehicle)", "(:objects t - truck)");
  ASSERT_EQ(model.types.size(), 3U);
  EXPECT_TRUE(model.isSubtype(model.objects[0].type, 2));
  EXPECT_EQ(model.types[2].name.name, "vehicle");
  EXPECT_FALSE(model.isSubtype(2, 1));
}

TEST(Link, ATypeMayHaveSeveralParents) {
  const std::string domain =
      "(:types tray - movable tray - surface cup - movable shelf - surface) "
      "(:predicates (on ?m - movable ?s - surface)) "
      "(:action put :parameters (?m - movable ?s - surface) :effect (on ?m ?s)) "
      "(:action stack :parameters (?m - movable ?s - movable) :precondition (on ?m ?s) "
      ":effect (not (on ?m ?s)))";
  const Model model =
      linked(domain, "(:objects t - tray c - cup s - shelf) (:init (on c t) (on t s))");
  EXPECT_EQ(model.init.size(), 2U);
  const TypeId tray = model.objects[0].type;
  const TypeId cup = model.objects[1].type;
  const TypeId shelf = model.objects[2].type;
  EXPECT_TRUE(model.isSubtype(tray, model.predicates[0].parameter_types[0]));
  EXPECT_TRUE(model.isSubtype(tray, model.predicates[0].parameter_types[1]));
  EXPECT_TRUE(
      model.overlap(model.predicates[0].parameter_types[0], model.predicates[0].parameter_types[1]))
      << "trays are both";
  EXPECT_FALSE(model.overlap(cup, shelf));
  EXPECT_EQ(
      linkError("(define (domain d) " + domain + ")",
                "(define (problem p) (:domain d)\n(:objects c - cup) (:init (on c c)) (:goal ()))"),
      "p.pddl:2:33: 'c' is of type 'cup', but 'on' takes 'surface' there");
}

TEST(Link, APreconditionMayMakeAParameterOneOfSeveralTypes) {
  const std::string types =
      "(:types tray - movable tray - surface) (:predicates (clear ?s - surface) (held ?m - "
      "movable))";
  const std::string take = "(:action take :parameters (?m - movable) ";
  EXPECT_EQ(
      domainFault(types + take + ":precondition (clear ?m) :effect (and (held ?m) (clear ?m)))"),
      "no error");
  EXPECT_EQ(domainFault(types + take + ":effect (clear ?m))"),
            "d.pddl:2:150: '?m' is of type 'movable', but 'clear' takes 'surface' there in action "
            "'take', and no precondition makes it one");
}

TEST(Link, SeveralParentsMayMeetAgain) {
  // Twenty diamonds: a walk over every way up would take a million steps.
  std::string types;
  for (int i = 0; i < 20; ++i) {
    const std::string n = std::to_string(i);
    const std::string above = std::to_string(i + 1);
    types +=
        "a" + n + " - l" + n + " a" + n + " - r" + n + " l" + n + " r" + n + " - a" + above + " ";
  }
  const Model model = linked("(:types " + types + ") (:predicates (p ?x - a20))",
                             "(:objects x - a0) (:init (p x))");
  EXPECT_EQ(model.init.size(), 1U);
}

TEST(Link, ATypeBelowItselfIsJustAType) {
  // The line of the parent alone ends without a type, so that the next one's counts for it, too.
  const Model model =
      linked("(:types\r\n shape\r\n square Shape - SHAPE\r\n)", "(:objects s - square)");
  ASSERT_EQ(model.types.size(), 3U);
  EXPECT_EQ(model.types[1].name.name, "shape");
  EXPECT_TRUE(model.isSubtype(2, 1));
  EXPECT_FALSE(model.isSubtype(1, 2));
}

TEST(Link, CostsOfAnActionAddUp) {
  const Model model = linked(
      "(:functions (total-cost) (way ?x) (noise)) (:action go :parameters (?x) :effect (and "
      "(increase (total-cost) 2) (increase (total-cost) (way ?x)) (increase (total-cost) (noise)) "
      "(increase (total-cost) 5)))",
      "");
  EXPECT_EQ(model.schemas[0].constant_cost, 7);
  EXPECT_EQ(model.schemas[0].function_costs.size(), 2U);
}

TEST(Link, NamesMatchWithoutCaseInAsciiOnly) {
  const Model model = linked("(:predicates (liegt-in ?x ?y))",
                             "(:objects KüCHE büro Ü ü) (:init (Liegt-In küche büro))");
  EXPECT_EQ(model.objects.size(), 4U);
  EXPECT_EQ(model.name(model.init[0]).text(), "(liegt-in küche büro)");
  EXPECT_EQ(model.spelling(model.name(model.init[0])), "(liegt-in KüCHE büro)");
}

TEST(Link, TheDomainsFaultsComeFirst) {
  const std::string problem =
      "(define (problem p) (:domain d) (:objects rex - robot) (:init) (:goal ()))";
  EXPECT_EQ(linkError("(define (domain d)\n(:predicates (in ?r - robot)))", problem),
            "d.pddl:2:23: unknown type 'robot'; the domain declares no types");
  EXPECT_EQ(
      linkError("(define (domain d) (:types room)\n(:action a :parameters (?r - robot)))", problem),
      "d.pddl:2:30: unknown type 'robot'");
  EXPECT_EQ(linkError("(define (domain d) (:types room) (:predicates (p ?x))\n(:action a "
                      ":precondition (exists (?x - robots) (p ?x))))",
                      problem),
            "d.pddl:2:40: unknown type 'robots'");
  EXPECT_EQ(linkError("(define (domain d) (:types room))", problem),
            "p.pddl:1:49: unknown type 'robot'")
      << "no fault of the domain";
}

TEST(Link, ADomainMayNameTheProblemsObjects) {
  const std::string domain =
      "(define (domain d) (:types t) (:predicates (p ?x - t)) (:action a :effect (p k)))";
  EXPECT_NO_THROW(checkDomain(parseDomain({"d.pddl", domain})));
  EXPECT_EQ(linkError(domain, "(define (problem p) (:domain d) (:objects k - t) (:goal (p k)))"),
            "no error");
  EXPECT_EQ(linkError(domain, "(define (problem p) (:domain d) (:goal ()))"),
            "d.pddl:1:78: unknown object 'k'");
}

TEST(Link, FilesThatHaveChangedPlacesAreNamed) {
  const std::string wrong =
      "d.pddl:1:10: expected 'domain', found 'problem': the two files are the wrong way round; "
      "p.pddl defines the domain";
  const Source first{"d.pddl", kTeaProblem};
  const Source second{"p.pddl", "; the kitchen's\r\n(DEFINE\t(Domain tea))"};
  EXPECT_EQ(samples::errorOf<SyntaxError>([&] { readModel(first, second); }), wrong);
  EXPECT_EQ(faults(first, second), std::vector<std::string>{wrong});
  EXPECT_EQ(samples::errorOf<SyntaxError>([&] {
              readModel(first, {"p.pddl", kTeaProblem});
            }),
            "d.pddl:1:10: expected 'domain', found 'problem'");
}

TEST(Link, SubtypesAreTransitive) {
  const Model model = linked("(:types c - b b - a a x)", "");
  const auto type = [&](const std::string& name) {
    for (TypeId id = 0;; ++id) {
      if (model.types.at(id).name.name == name) return id;
    }
  };
  EXPECT_TRUE(model.isSubtype(type("c"), type("a")));
  EXPECT_TRUE(model.isSubtype(type("c"), kObjectType));
  EXPECT_TRUE(model.isSubtype(type("x"), type("x")));
  EXPECT_FALSE(model.isSubtype(type("a"), type("c")));
  EXPECT_FALSE(model.isSubtype(type("x"), type("a")));
  EXPECT_FALSE(model.isSubtype(kObjectType, type("a")));
}

TEST(Link, ObjectBesideAnotherParentAddsNothing) {
  // As in the IPC's storage domain: `area - object` and later `area - surface`.
  const Model model = linked("(:types area - object area - surface surface - object)", "");
  EXPECT_TRUE(model.isSubtype(1, 2));
  EXPECT_TRUE(linked("(:types area - surface area - object)", "").isSubtype(1, 2));
}

TEST(Link, AConstantMayBeRepeatedAmongTheObjects) {
  const Model model = linked("(:types t) (:constants c - t)", "(:objects c - t d - t)");
  EXPECT_EQ(model.objects.size(), 2U);
}

TEST(Link, AParameterMayBeWiderThanItsCondition) {
  const Model model = linked(
      "(:types box ball) (:predicates (open ?b - box)) "
      "(:action shut :parameters (?x) :precondition (open ?x) :effect (not (open ?x)))"
      "(:action keep :parameters (?x) :precondition (open ?x) :effect (open ?x))",
      "");
  EXPECT_EQ(model.schemas.size(), 2U);
}

TEST(Link, EqualitiesOfTheGoalAreDecidedAtOnce) {
  const std::string domain = "(define (domain d))";
  const auto problem = [](const std::string& goal) {
    return "(define (problem p) (:domain d) (:objects a b)\n(:goal " + goal + "))";
  };
  EXPECT_TRUE(readModel({"d", domain}, {"p", problem("(not (= a b))")}).goal.empty());
  EXPECT_EQ(linkError(domain, problem("(= a b)")),
            "p.pddl:2:9: this equality of the goal can never hold");
}

TEST(Link, TheProblemNamesItsDomain) {
  EXPECT_EQ(linkError(kTeaDomain, with(kTeaProblem, ":domain tea", ":domain coffee")),
            "p.pddl:2:12: the problem is for domain 'coffee', but d.pddl defines 'Tea'");
}

struct Fault {
  std::string text;
  std::string message;
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.text;
}

class DomainFault : public testing::TestWithParam<Fault> {};

TEST_P(DomainFault, IsNamedWithItsPosition) {
  EXPECT_EQ(domainFault(GetParam().text), "d.pddl:2:" + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Declarations, DomainFault,
    testing::Values(
        Fault{"(:types a - b b - c c - a x - a)",
              "9: type 'a' is its own ancestor: 'a' at 2:9 stands below 'b', 'b' at "
              "2:15 stands below 'c', 'c' at 2:21 stands below 'a' (a '-' counts for "
              "all names before it that have no type yet)"},
        Fault{"(:types x - y y - a y - b b - y)",
              "15: type 'y' is its own ancestor: 'y' at 2:15 stands below 'b', 'b' at "
              "2:27 stands below 'y' (a '-' counts for all names before it that have no "
              "type yet)"},
        Fault{"(:types object - thing)", "9: 'object' is above all types and has no parent"},
        Fault{"(:types place) (:constants c - plaec)",
              "32: unknown type 'plaec'; did you mean 'place'?"},
        Fault{"(:predicates (p ?x - t))", "22: unknown type 't'; the domain declares no types"},
        Fault{"(:predicates (p) (P ?x))", "19: predicate 'P' is declared twice"},
        Fault{"(:functions (f) (f ?x))", "18: function 'f' is declared twice"},
        Fault{"(:constants c C)", "15: object 'C' is declared twice"},
        Fault{"(:action a) (:action A)", "22: action 'A' is declared twice"}));

const std::string kTypes = "(:types box ball) (:predicates (in ?x - box) (q))";

class ActionFault : public testing::TestWithParam<Fault> {};

TEST_P(ActionFault, IsNamedWithItsPosition) {
  EXPECT_EQ(domainFault(kTypes + "(:functions (f ?x - box))(:constants b - box)\n(:action go\n" +
                        GetParam().text + ")"),
            "d.pddl:4:" + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Actions, ActionFault,
    testing::Values(
        Fault{":parameters (?x ?X)", "17: parameter '?X' stands twice in action 'go'"},
        Fault{":parameters (?x - bal)", "19: unknown type 'bal'; did you mean 'ball'?"},
        Fault{":precondition (im b)", "16: unknown predicate 'im'"},
        Fault{":precondition (in)", "16: 'in' takes 1 argument, found 0"},
        Fault{":precondition (q b)", "16: 'q' takes 0 arguments, found 1"},
        Fault{":precondition (in c)", "19: unknown object 'c'"},
        Fault{":parameters (?box) :precondition (in ?bix)",
              "38: unknown parameter '?bix' in action 'go'; did you mean '?box'?"},
        Fault{":precondition (= b ?y)", "20: unknown parameter '?y' in action 'go'"},
        Fault{":parameters (?x - ball) :precondition (in ?x)",
              "43: '?x' is of type 'ball', but 'in' takes 'box' there in action 'go'"},
        Fault{":parameters (?x - ball) :effect (not (in ?x))",
              "42: '?x' is of type 'ball', but 'in' takes 'box' there in action 'go'"},
        Fault{":parameters (?x) :effect (in ?x)",
              "30: '?x' is of type 'object', but 'in' takes 'box' there in action 'go', and no "
              "precondition makes it one"},
        Fault{":effect (increase (total-cost) (g b))", "33: unknown function 'g'"},
        Fault{":effect (increase (total-cost) (f))", "33: 'f' takes 1 argument, found 0"},
        Fault{":parameters (?x - ball) :effect (increase (total-cost) (f ?x))",
              "59: '?x' is of type 'ball', but 'f' takes 'box' there in action 'go'"}));

class ProblemFault : public testing::TestWithParam<Fault> {};

TEST_P(ProblemFault, IsNamedWithItsPosition) {
  const std::string domain =
      "(define (domain d) (:types box ball) (:constants k - box) (:functions (f ?x - box))"
      "(:predicates (in ?x - box) (handempty)))";
  EXPECT_EQ(linkError(domain, "(define (problem p) (:domain d)\n" + GetParam().text + ")"),
            "p.pddl:2:" + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Problems, ProblemFault,
    testing::Values(
        Fault{"(:goal (handempy))", "9: unknown predicate 'handempy'; did you mean 'handempty'?"},
        Fault{"(:goal (in))", "9: 'in' takes 1 argument, found 0"},
        Fault{"(:goal (not (in c)))", "17: unknown object 'c'"},
        Fault{"(:goal ()) (:objects a b A)", "26: object 'A' is declared twice"},
        Fault{"(:goal ()) (:objects k)", "22: object 'k' is declared twice"},
        Fault{"(:goal ()) (:objects k k - box)", "24: object 'k' is declared twice"},
        Fault{"(:goal ()) (:objects a - bix)", "26: unknown type 'bix'; did you mean 'box'?"},
        Fault{"(:goal ()) (:objects a - ball) (:init (in a))",
              "43: 'a' is of type 'ball', but 'in' takes 'box' there"},
        Fault{"(:goal ()) (:objects a) (:init (in a))",
              "36: 'a' is of type 'object', but 'in' takes 'box' there"},
        Fault{"(:goal ()) (:init (handempty) (not (handempty)))",
              "37: '(handempty)' is both true and false in :init"},
        Fault{"(:goal ()) (:init (not (on a)))", "25: unknown predicate 'on'"},
        Fault{"(:goal ()) (:init (= (g k) 1))", "23: unknown function 'g'"},
        Fault{"(:goal ()) (:init (= (f k) 1) (= (F K) 2))",
              "35: the function 'F' has two values here, 1 and 2"}));

TEST(Faults, NameEachTextsSyntaxThenTheFirstContradiction) {
  EXPECT_TRUE(faults({"d", kTeaDomain}, {"p", kTeaProblem}).empty());
  const std::vector<std::string> both = faults({"d", "(define"}, {"p", "(define"});
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].substr(0, 6), "d:1:8:");
  EXPECT_EQ(both[1].substr(0, 6), "p:1:8:");
  const std::vector<std::string> one =
      faults({"d", kTeaDomain}, {"p", with(kTeaProblem, "(full mug)", "(full tea)")});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0], "p:6:21: unknown object 'tea'");
}

}  // namespace
}  // namespace goal_alignment::pddl
