// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/grounding/grounder.h"
#include "oracles/lifted_space.h"
#include "oracles/random_pddl.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"

/// Formulas and conditional effects, grounded, against the lifted model by brute force.
namespace goal_alignment::grounding {
namespace {

using oracles::Atoms;
using oracles::Facts;
using oracles::GroundAction;

constexpr std::size_t kMaxStates = 200;

std::vector<Literal> someNegations(RandomSource& random, const oracles::ModelSketch& sketch) {
  std::vector<Literal> literals;
  for (const auto& predicate : sketch.predicates) {
    for (const std::string& atom : sketch.atomsOf(predicate)) {
      if (oracles::chance(random, 0.3)) literals.push_back({GroundName::parse(atom), true});
    }
  }
  return literals;
}

Facts told(const task::Task& task, const Atoms& atoms) {
  Facts facts;
  for (task::FactId fact = 0; fact < task.facts.size(); ++fact) {
    if (oracles::holds({task.facts[fact]}, atoms)) facts.insert(fact);
  }
  return facts;
}

/// By an action's name, where it leads to; what changes nothing is left out.
using Steps = std::set<std::pair<GroundName, Facts>>;

Steps liftedSteps(const task::Task& task, const std::vector<GroundAction>& actions,
                  const Atoms& atoms) {
  Steps steps;
  for (const GroundAction& action : actions) {
    if (!oracles::applicable(action, atoms)) continue;
    const Facts after = told(task, oracles::successor(action, atoms));
    if (after != told(task, atoms)) steps.emplace(action.name, after);
  }
  return steps;
}

Steps groundedSteps(const task::Task& task, const Facts& facts) {
  Steps steps;
  for (const task::OperatorId op : oracles::applicableOperators(task, facts)) {
    const Facts after = oracles::successor(task.operators[op], facts);
    if (after != facts) steps.emplace(task.operators[op].name, after);
  }
  return steps;
}

RC_GTEST_PROP(OperatorBuilder, EveryStateHasTheStepsOfTheLiftedModel, ()) {
  RandomSource random = oracles::anySource();
  const oracles::ModelSketch sketch = oracles::randomSmallAdlSketch(random, kMaxStates);
  const pddl::Model model = sketch.model();
  RC_LOG() << sketch.domainText() << sketch.problemText();
  const GroundTask ground = grounding::ground(model, someNegations(random, sketch), {}, {});
  RC_ASSERT(oracles::initialFacts(ground.task) == told(ground.task, oracles::initialAtoms(model)));
  const std::vector<GroundAction> actions = oracles::allActions(model);
  for (const Atoms& atoms : oracles::LiftedSpace(model, kMaxStates).states()) {
    RC_ASSERT(groundedSteps(ground.task, told(ground.task, atoms)) ==
              liftedSteps(ground.task, actions, atoms));
  }
}

RC_GTEST_PROP(OperatorBuilder, TheGoalHoldsInTheSameStates, ()) {
  RandomSource random = oracles::anySource();
  const oracles::ModelSketch sketch = oracles::randomSmallAdlSketch(random, kMaxStates);
  const pddl::Model model = sketch.model();
  RC_LOG() << sketch.domainText() << sketch.problemText();
  const std::vector<Literal> literals = model.goalLiterals();
  const GroundTask ground = grounding::ground(model, literals, {}, {});
  const task::Goal goal = ground.goal(literals);
  const oracles::GroundFormula condition = oracles::goalCondition(model);
  for (const Atoms& atoms : oracles::LiftedSpace(model, kMaxStates).states()) {
    const bool expected = oracles::holds(literals, atoms) && oracles::holds(condition, atoms);
    RC_ASSERT(oracles::holds(goal, told(ground.task, atoms)) == expected);
  }
}

RC_GTEST_PROP(OperatorBuilder, OperatorsAreWellFormed, ()) {
  RandomSource random = oracles::anySource();
  const pddl::Model model = oracles::randomAdlSketch(random).model();
  std::set<std::pair<GroundName, task::FactSet>> known;
  for (const task::Operator& op : grounding::ground(model, {}, {}, {}).task.operators) {
    RC_ASSERT(known.emplace(op.name, op.precondition).second);  // each alternative once
    std::vector<const task::FactSet*> sets = {&op.precondition, &op.add, &op.del};
    for (const task::ConditionalEffect& effect : op.conditional) {
      RC_ASSERT(!effect.condition.empty());
      RC_ASSERT(!effect.add.empty() || !effect.del.empty());
      sets.insert(sets.end(), {&effect.condition, &effect.add, &effect.del});
    }
    for (const task::FactSet* set : sets)
      RC_ASSERT(*set == task::makeFactSet(*set));
  }
}

pddl::Model read(const std::string& domain, const std::string& problem) {
  return pddl::readModel({"d.pddl", "(define (domain d) " + domain + ")"},
                         {"p.pddl", "(define (problem p) (:domain d) " + problem + ")"});
}

TEST(OperatorBuilder, AnAtomAddedUnderAConditionKeepsItsComplementRight) {
  const pddl::Model model = read(
      "(:predicates (p) (q) (r)) (:action a :effect (and (not (p)) (when (q) (p))))"
      "(:action b :effect (and (q) (r))) (:action c :effect (not (q)))",
      "(:init (p)) (:goal (not (p)))");
  const GroundTask ground = grounding::ground(model, model.goalLiterals(), {}, {});
  const std::vector<GroundAction> actions = oracles::allActions(model);
  for (const Atoms& atoms : oracles::LiftedSpace(model, kMaxStates).states()) {
    EXPECT_EQ(groundedSteps(ground.task, told(ground.task, atoms)),
              liftedSteps(ground.task, actions, atoms));
  }
}

TEST(OperatorBuilder, StaticConditionsDisappear) {
  const pddl::Model model = read(
      "(:predicates (road ?x ?y) (at ?x) (seen ?x) (odd))"
      "(:action go :parameters (?x ?y) :precondition (and (at ?x) (or (road ?x ?y) (road ?y ?x)))"
      " :effect (and (not (at ?x)) (at ?y) (when (odd) (seen ?x))"
      " (when (not (odd)) (seen ?y))))",
      "(:objects a b c) (:init (at a) (road b a) (road b c)) (:goal (and))");
  const GroundTask ground = grounding::ground(model, {}, {}, {});
  std::multiset<std::string> names;
  for (const task::Operator& op : ground.task.operators) {
    names.insert(op.name.text());
    EXPECT_TRUE(op.conditional.empty());
    EXPECT_EQ(op.precondition.size(), 1U);
    EXPECT_EQ(op.add.size(), 2U);
  }
  EXPECT_EQ(names, (std::multiset<std::string>{"(go a b)", "(go b a)", "(go b c)", "(go c b)"}));
}

TEST(OperatorBuilder, DisjunctionsAreOperatorsOfOneName) {
  const pddl::Model model = read(
      "(:predicates (p) (q) (r)) (:action a :precondition (or (p) (q) (and (p) (r)))"
      " :effect (r)) (:action b :effect (and (p) (q))) (:action c :effect (not (p)))",
      "(:goal (r))");
  std::size_t alternatives = 0;
  for (const task::Operator& op : grounding::ground(model, {}, {}, {}).task.operators) {
    if (op.name.name == "a") ++alternatives;
  }
  EXPECT_EQ(alternatives, 2U) << "(and (p) (r)) is implied by (p)";
}

/// n pairs of atoms, of each of which one must hold: 2^n alternatives.
std::string pairs(int count) {
  std::string text = "(and";
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    text += " (or (p o" + n + ") (q o" + n + "))";
  }
  return text + ")";
}

std::string objects(int count) {
  std::string text = "(:objects";
  for (int i = 0; i < count; ++i)
    text += " o" + std::to_string(i);
  return text + ")";
}

std::string refusal(const pddl::Model& model) {
  try {
    grounding::ground(model, {}, {}, {});
  } catch (const pddl::UnsupportedError& error) {
    return error.what();
  }
  return "";
}

TEST(OperatorBuilder, MoreAlternativesThanThereIsRoomForAreRefusedByName) {
  const std::string predicates =
      "(:predicates (p ?x) (q ?x) (r)) (:action fill :parameters (?x) :effect (and (p ?x) (q ?x)))"
      "(:action empty :parameters (?x) :effect (and (not (p ?x)) (not (q ?x))))";
  const pddl::Model goal = read(predicates, objects(14) + "(:goal " + pairs(14) + ")");
  EXPECT_EQ(refusal(goal), "p.pddl: not supported yet: more than 10000 alternatives in the goal");
  const pddl::Model action =
      read(predicates + "(:action go :precondition (forall (?x) (or (p ?x) (q ?x))) :effect (r))",
           objects(14) + "(:goal (r))");
  EXPECT_EQ(refusal(action),
            "d.pddl: not supported yet: more than 10000 alternatives in the conditions of action "
            "'go'");
  const pddl::Model fewer = read(predicates, objects(13) + "(:goal " + pairs(13) + ")");
  EXPECT_EQ(grounding::ground(fewer, {}, {}, {}).goal({}).alternatives.size(), 8192U);
}

// More alternatives than are lifted, fewer than are refused.
TEST(OperatorBuilder, AlternativesThatAreNotLiftedAreGrounded) {
  const pddl::Model model = read(
      "(:predicates (p ?x) (q ?x) (r)) (:action fill :parameters (?x) :effect (and (p ?x) (q ?x)))"
      "(:action empty :parameters (?x) :effect (and (not (p ?x)) (not (q ?x))))"
      "(:action go :parameters (?a ?b ?c ?d ?e ?f ?g) :precondition (and (not (= ?a ?b))"
      " (or (p ?a) (q ?a)) (or (p ?b) (q ?b)) (or (p ?c) (q ?c)) (or (p ?d) (q ?d))"
      " (or (p ?e) (q ?e)) (or (p ?f) (q ?f)) (or (p ?g) (q ?g))) :effect (r))",
      objects(2) + "(:goal (r))");
  std::size_t alternatives = 0;
  for (const task::Operator& op : grounding::ground(model, {}, {}, {}).task.operators) {
    if (op.name.text() == "(go o0 o1 o0 o1 o0 o1 o0)") ++alternatives;
  }
  EXPECT_EQ(alternatives, 4U);
}

TEST(OperatorBuilder, AGoalThatNothingReachesHasNoAlternative) {
  const pddl::Model model =
      read("(:predicates (p) (q)) (:action a :effect (p))", "(:goal (or (q) (and (p) (q))))");
  EXPECT_TRUE(grounding::ground(model, {}, {}, {}).goal({}).alternatives.empty());
}

TEST(OperatorBuilder, NestedQuantifiersEndAtTheDeadline) {
  std::string formula = "(p ?a)";
  for (const char* variable : {"a", "b", "c", "d", "e", "f", "g", "h"})
    formula = std::string(variable == std::string("a") ? "(exists" : "(forall") + " (?" + variable +
              ") " + formula + ")";
  const pddl::Model model = read(
      "(:predicates (p ?x) (r)) (:action go :parameters (?x) :effect (p ?x))"
      "(:action end :precondition " +
          formula + " :effect (r))",
      objects(100) + "(:goal (r))");
  EXPECT_THROW(grounding::ground(model, {}, {}, Limits{}.withSeconds(0.05)), LimitReached);
}

}  // namespace
}  // namespace goal_alignment::grounding
