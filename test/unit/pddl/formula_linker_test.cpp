// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "goal_alignment/pddl/model.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

const std::string kDomain =
    "(define (domain d) (:types cup pot - vessel vessel place)\n"
    "(:predicates (p ?v - vessel) (q ?c - cup) (r) (in ?x - (either cup place)))\n";
const std::string kProblem =
    "(define (problem p) (:domain d)\n"
    "(:objects A - cup B - pot C - place D - (either cup pot) E - (either cup vessel))\n";

Model linked(const std::string& body, const std::string& goal = "()") {
  return readModel({"d.pddl", kDomain + "(:action go " + body + "))"},
                   {"p.pddl", kProblem + "(:goal " + goal + "))"});
}

std::string error(const std::string& body, const std::string& goal = "()") {
  return samples::linkError(kDomain + "(:action go\n" + body + "))",
                            kProblem + "(:goal " + goal + "))");
}

std::string conditionText(const std::string& precondition) {
  const Model model = linked(":parameters (?x - vessel) :precondition " + precondition);
  const Schema& schema = model.schemas.at(0);
  std::vector<Parameter> variables = schema.parameters;
  variables.insert(variables.end(), schema.quantified.begin(), schema.quantified.end());
  return model.text(schema.condition, variables);
}

TEST(FormulaLinker, NegationsStandAtAtomsAlone) {
  EXPECT_EQ(conditionText("(not (and (p ?x) (not (r))))"), "(or (not (p ?x)) (r))");
  EXPECT_EQ(conditionText("(imply (p ?x) (or (r) (q A)))"), "(or (not (p ?x)) (or (q a) (r)))");
  EXPECT_EQ(conditionText("(not (forall (?y - cup) (imply (q ?y) (= ?x ?y))))"),
            "(exists (?1 - cup) (and (not (= ?1 ?x)) (q ?1)))");
  EXPECT_EQ(conditionText("(not (exists (?y - cup) (q ?y)))"), "(forall (?1 - cup) (not (q ?1)))");
}

TEST(FormulaLinker, LiteralsStayApartFromTheRest) {
  const Model model = linked(
      ":parameters (?x ?y - vessel) :precondition (and (p ?x) (not (or (r) (= ?x ?y))) (or (r)))");
  const Schema& schema = model.schemas.at(0);
  EXPECT_EQ(schema.precondition.size(), 2U);
  EXPECT_EQ(schema.equalities.size(), 1U);
  EXPECT_EQ(schema.condition.parts.size(), 1U);
}

TEST(FormulaLinker, InnerVariablesHideOuterOnes) {
  EXPECT_EQ(conditionText("(forall (?x - cup) (exists (?x - pot) (or (p ?x) (r))))"),
            "(forall (?1 - cup) (exists (?2 - pot) (or (p ?2) (r))))");
  EXPECT_EQ(conditionText("(or (exists (?x - cup) (q ?x)) (p ?x))"),
            "(or (exists (?1 - cup) (q ?1)) (p ?x))");
}

TEST(FormulaLinker, EffectsAreFlattened) {
  const Model model = linked(
      ":parameters (?x - vessel) :effect (and (p ?x) (forall (?c - cup) (and (q ?c)"
      " (when (p ?c) (forall (?v - vessel) (when (not (r)) (and (not (q ?c)) (p ?v))))))))");
  const Schema& schema = model.schemas.at(0);
  ASSERT_EQ(schema.conditional.size(), 2U);
  EXPECT_TRUE(schema.conditional[0].condition.trivial());
  const ConditionalEffect& inner = schema.conditional[1];
  EXPECT_EQ(inner.variables, (std::vector<int>{1, 2}));
  EXPECT_EQ(inner.condition.parts.size(), 2U);
  EXPECT_EQ(inner.add.size(), 1U);
  EXPECT_EQ(inner.del.size(), 1U);
  EXPECT_TRUE(model.predicates.at(1).fluent);
}

TEST(FormulaLinker, UnionsHoldWhatAllOrAnyOfTheirMembersHold) {
  const Model model = linked("");
  const auto type = [&](const char* object) {
    return model.objects[*model.findObject(object)].type;
  };
  const TypeId in = model.predicates.at(3).parameter_types.at(0);
  EXPECT_TRUE(model.isSubtype(type("a"), in));
  EXPECT_TRUE(model.isSubtype(type("c"), in));
  EXPECT_FALSE(model.isSubtype(type("b"), in));
  EXPECT_FALSE(model.isSubtype(type("d"), in)) << "it may be a pot";
  EXPECT_TRUE(model.isSubtype(type("d"), model.predicates.at(0).parameter_types.at(0)));
  EXPECT_EQ(model.types[type("e")].name.name, "vessel") << "every cup is one";
  EXPECT_TRUE(model.overlap(type("d"), in));
  EXPECT_FALSE(model.overlap(type("b"), in));
}

TEST(FormulaLinker, GoalsKeepTheirLiterals) {
  const Model model = linked("", "(and (p A) (not (or (r) (not (p B)))) (or (r) (q A)))");
  EXPECT_EQ(model.goalLiterals(),
            (std::vector<Literal>{Literal::parse("(p a)"), Literal::parse("(not (r))"),
                                  Literal::parse("(p b)")}));
  EXPECT_EQ(model.goalConditionText(), "(or (q a) (r))");
}

TEST(FormulaLinker, ConditionsOfOneMeaningMayHaveOneText) {
  const auto text = [](const std::string& goal) { return linked("", goal).goalConditionText(); };
  EXPECT_EQ(text("(or (r) (q A) (R))"), text("(imply (not (q a)) (r))"));
  EXPECT_EQ(text("(forall (?c - cup) (q ?c))"), text("(not (exists (?x - Cup) (not (q ?x))))"));
  EXPECT_EQ(text("(exists (?c - cup) (= A ?c))"), text("(exists (?d - cup) (= ?d a))"));
  EXPECT_NE(text("(forall (?c - cup) (p ?c))"), text("(forall (?c - pot) (p ?c))"));
  EXPECT_EQ(text("(and (r) (q A))"), "");
}

TEST(FormulaLinker, AGoalSetByHandHasNoCondition) {
  Model model = linked("", "(or (r) (q A))");
  model.setGoal({Literal::parse("(r)")});
  EXPECT_EQ(model.goalConditionText(), "");
}

TEST(FormulaLinker, NamesWhatIsWrongInAFormula) {
  EXPECT_EQ(error(":precondition (or (s))"), "d.pddl:4:20: unknown predicate 's'");
  EXPECT_EQ(error(":precondition (forall (?x) (p ?y))"),
            "d.pddl:4:31: unknown parameter '?y' in action 'go'");
  EXPECT_EQ(error(":precondition (and (exists (?x) (r)) (p ?x))"),
            "d.pddl:4:41: unknown parameter '?x' in action 'go'");
  EXPECT_EQ(error(":precondition (exists (?x ?x) (r))"),
            "d.pddl:4:27: variable '?x' stands twice in action 'go'");
  EXPECT_EQ(error(":precondition (or (in B))"),
            "d.pddl:4:23: 'B' is of type 'pot', but 'in' takes '(either cup place)' there in "
            "action 'go'");
  EXPECT_EQ(error(":effect (forall (?x - vessel) (when (p ?x) (q ?x)))"),
            "d.pddl:4:47: '?x' is of type 'vessel', but 'q' takes 'cup' there in action 'go', and "
            "no precondition makes it one");
  EXPECT_EQ(error(":effect (forall (?x - vessel) (when (q ?x) (in ?x)))"), "no error");
  EXPECT_EQ(error("", "(exists (?x - mug) (p ?x))"), "p.pddl:3:22: unknown type 'mug'");
  EXPECT_EQ(error("", "(exists (?x ?x) (r))"),
            "p.pddl:3:20: variable '?x' stands twice in the goal");
  EXPECT_EQ(error("", "(or (p C))"),
            "p.pddl:3:15: 'C' is of type 'place', but 'p' takes 'vessel' there in the goal");
  EXPECT_EQ(error("", "(exists (?x - (either cup mug)) (p ?x))"),
            "p.pddl:3:34: unknown type 'mug'");
}

}  // namespace
}  // namespace goal_alignment::pddl
