// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/validation/execution.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/pddl/parser.h"
#include "oracles/lifted_space.h"
#include "oracles/random_pddl.h"
#include "oracles/seeds.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::validation {
namespace {

using Kind = Violation::Kind;
using pddl::Model;

std::vector<GroundName> plan(const std::string& text) {
  return pddl::parsePlan({"plan", text}).steps;
}

std::vector<Literal> literals(const std::string& text) {
  return pddl::parseLiterals({"goal", text});
}

const std::string kGood = "(move pot shelf table) (heat pot) (pour pot mug)";

Model small(const std::string& actions, const std::string& problem) {
  return pddl::readModel(
      {"d", "(define (domain d) (:predicates (p ?x) (q)) " + actions + ")"},
      {"p", "(define (problem p) (:domain d) (:objects a b) (:goal ()) " + problem + ")"});
}

TEST(Execute, RunsAGoodPlan) {
  const Model model = pddl::samples::tea();
  const Execution execution = execute(model, plan(kGood));
  EXPECT_FALSE(execution.violation) << execution.violation->message;
  EXPECT_EQ(execution.stepsRun(), 3U);
  EXPECT_EQ(execution.costs, (std::vector<std::int64_t>{0, 3, 8, 8}));
  EXPECT_EQ(execution.cost(), 8);
  EXPECT_TRUE(unsatisfied(model, execution.finalState(), model.goalLiterals()).empty());
  execution.forEachState([&](std::size_t step, const AtomSet& state) {
    if (step != 2) return;
    EXPECT_EQ(unsatisfied(model, state, model.goalLiterals()), model.goalLiterals())
        << "before the pouring the pot is hot and the mug empty";
  });
}

TEST(Execute, TheEmptyPlanEndsWhereItBegan) {
  const Model model = pddl::samples::tea();
  const Execution execution = execute(model, {});
  EXPECT_EQ(execution.stepsRun(), 0U);
  EXPECT_EQ(execution.finalState(), AtomSet(model.init.begin(), model.init.end()));
  EXPECT_EQ(execution.cost(), 0);
}

TEST(Execute, AddsWinOverDeletes) {
  const Model model =
      small("(:action a :parameters (?x ?y) :effect (and (p ?x) (not (p ?y)) (not (q)) (q)))",
            "(:init (p a) (p b))");
  const AtomSet same = execute(model, plan("(a a a)")).finalState();
  EXPECT_EQ(same.size(), 3U) << "p(a) is deleted and added, q too";
  EXPECT_EQ(execute(model, plan("(a a b)")).finalState().size(), 2U);
}

TEST(Execute, WithoutAMetricEveryActionCostsOne) {
  const Model model = small("(:action a :effect (increase (total-cost) 7)) (:action b)", "(:init)");
  EXPECT_EQ(execute(model, plan("(a) (b) (a)")).cost(), 3);
}

TEST(Execute, WithAMetricAnActionWithoutCostIsFree) {
  const Model model = small("(:action a :effect (increase (total-cost) 7)) (:action b)",
                            "(:metric minimize (total-cost))");
  EXPECT_EQ(execute(model, plan("(a) (b) (a)")).cost(), 14);
}

TEST(Execute, AMissingCostIsNamed) {
  const Model model = pddl::readModel(
      {"d", pddl::samples::kTeaDomain},
      {"tea.pddl", pddl::samples::with(pddl::samples::kTeaProblem, "(= (way shelf table) 3)", "")});
  EXPECT_EQ(pddl::samples::errorOf<pddl::SemanticError>([&] { execute(model, plan(kGood)); }),
            "tea.pddl: the cost of (move Pot shelf Table) is not given: (way shelf Table) has no "
            "value in :init");
}

struct Broken {
  std::string plan;
  Kind kind;
  std::size_t step;
  std::string message;
};

void PrintTo(const Broken& broken, std::ostream* out) {
  *out << broken.plan;
}

class BrokenPlan : public testing::TestWithParam<Broken> {};

TEST_P(BrokenPlan, NamesTheStepAndWhatIsWrong) {
  const Broken& broken = GetParam();
  const Execution execution = execute(pddl::samples::tea(), plan(broken.plan));
  ASSERT_TRUE(execution.violation);
  EXPECT_EQ(execution.violation->message, broken.message);
  EXPECT_EQ(execution.violation->kind, broken.kind);
  EXPECT_EQ(execution.violation->step, broken.step);
  EXPECT_EQ(execution.stepsRun(), broken.step) << "what comes before the step is there";
  EXPECT_EQ(execution.violation->literal.has_value(), broken.kind == Kind::Precondition);
}

INSTANTIATE_TEST_SUITE_P(
    Plans, BrokenPlan,
    testing::Values(
        Broken{"(heet pot)", Kind::UnknownAction, 0,
               "step 1 (heet Pot): unknown action 'heet'; did you mean 'Heat'?"},
        Broken{"(move pot shelf table) (heat)", Kind::WrongArity, 1,
               "step 2 (Heat): 'Heat' takes 1 argument, found 0"},
        Broken{"(heat pot mug)", Kind::WrongArity, 0,
               "step 1 (Heat Pot Mug): 'Heat' takes 1 argument, found 2"},
        Broken{"(heat kettle)", Kind::UnknownObject, 0,
               "step 1 (Heat kettle): unknown object 'kettle'"},
        Broken{"(heat mug)", Kind::WrongType, 0,
               "step 1 (Heat Mug): 'Mug' is of type 'cup', but parameter '?k' takes 'kettle'"},
        Broken{"(heat pot)", Kind::Precondition, 0,
               "step 1 (Heat Pot): the precondition (at Pot Table) is false"},
        Broken{"(move pot shelf table) (heat pot) (heat pot)", Kind::Precondition, 2,
               "step 3 (Heat Pot): the precondition (not (hot Pot)) is false"},
        Broken{"(move pot shelf shelf)", Kind::Precondition, 0,
               "step 1 (move Pot shelf shelf): the precondition (not (= shelf shelf)) is false"}));

TEST(Execute, GivesTheFalsePreconditionAsALiteral) {
  const Model model = pddl::samples::tea();
  EXPECT_EQ(execute(model, plan("(heat pot)")).violation->literal,
            Literal::parse("(at pot table)"));
  EXPECT_EQ(execute(model, plan("(move pot shelf shelf)")).violation->literal,
            Literal::parse("(not (= shelf shelf))"));
}

TEST(Execute, NamesTheFalseFormulaWithItsObjects) {
  const Model model = small(
      "(:action a :parameters (?x ?y) :precondition (and (p ?x) (or (q) (forall (?z) (imply (p ?z)"
      " (= ?z ?x))))) :effect (q))",
      "(:init (p a) (p b))");
  const Execution execution = execute(model, plan("(a a b)"));
  ASSERT_TRUE(execution.violation);
  EXPECT_EQ(execution.violation->message,
            "step 1 (a a b): the precondition (or (forall (?1 - object) (or (= ?1 a) (not (p ?1))))"
            " (q)) is false");
  EXPECT_FALSE(execution.violation->literal);
}

TEST(Execute, ConditionsCountInTheStateBefore) {
  const Model model = small(
      "(:action swap :parameters (?x ?y) :effect (and (when (p ?x) (and (not (p ?x)) (p ?y)))"
      " (when (p ?y) (and (not (p ?y)) (p ?x)))))"
      "(:action all :effect (forall (?x) (when (not (p ?x)) (and (p ?x) (q)))))",
      "(:init (p a))");
  EXPECT_EQ(unsatisfied(model, execute(model, plan("(swap a b)")).finalState(),
                        literals("(not (p a)) (p b)")),
            std::vector<Literal>{});
  EXPECT_EQ(execute(model, plan("(all)")).finalState().size(), 3U);
  EXPECT_EQ(execute(model, plan("(swap a b) (swap a b)")).finalState(),
            execute(model, {}).finalState());
}

TEST(Execute, StopsAtADeadlineWithinAQuantifier) {
  std::string objects;
  for (int i = 0; i < 100; ++i)
    objects += " o" + std::to_string(i);
  const Model model = pddl::readModel(
      {"d",
       "(define (domain d) (:predicates (p)) (:action a :precondition (exists"
       " (?a ?b ?c ?d ?e ?f ?g ?h) (p)) :effect (p)))"},
      {"p", "(define (problem p) (:domain d) (:objects" + objects + ") (:goal (p)))"});
  EXPECT_THROW(execute(model, plan("(a)"), Limits{}.withSeconds(0.02)), LimitReached);
}

// Random plans of random ADL models, against what brute force makes of them.
RC_GTEST_PROP(Execute, AgreesWithBruteForceOnFormulas, ()) {
  RandomSource random = oracles::anySource();
  const oracles::ModelSketch sketch = oracles::randomAdlSketch(random);
  const Model model = sketch.model();
  RC_LOG() << sketch.domainText() << sketch.problemText();
  const std::vector<oracles::GroundAction> actions = oracles::allActions(model);
  std::vector<oracles::Atoms> states = {oracles::initialAtoms(model)};
  std::vector<GroundName> steps;
  bool runs = true;
  while (runs && !actions.empty() && steps.size() < 6) {
    const auto& action = actions[random.below(actions.size())];
    steps.push_back(action.name);
    runs = oracles::applicable(action, states.back());
    if (runs) states.push_back(oracles::successor(action, states.back()));
  }
  const Execution execution = execute(model, steps);
  RC_ASSERT(execution.violation.has_value() == !runs);
  RC_ASSERT(execution.stepsRun() == states.size() - 1);
  execution.forEachState([&](std::size_t step, const AtomSet& state) {
    oracles::Atoms names;
    for (const pddl::Atom& atom : state)
      names.insert(model.name(atom));
    RC_ASSERT(names == states.at(step));
  });
  RC_ASSERT(satisfiesCondition(model, execution.finalState()) ==
            oracles::holds(oracles::goalCondition(model), states.back()));
}

TEST(Fault, NamesTheConditionOfTheGoal) {
  const Model model = pddl::readModel(
      {"d", "(define (domain d) (:predicates (p ?x)) (:action a :parameters (?x) :effect (p ?x)))"},
      {"p", "(define (problem p) (:domain d) (:objects a b) (:goal (forall (?x) (p ?x))))"});
  EXPECT_EQ(fault(model, plan("(a a)"), {}),
            "the plan runs, but ends without the goal (forall (?1 - object) (p ?1))");
  EXPECT_EQ(fault(model, plan("(a a) (a b)"), {}), std::nullopt);
}

TEST(Unsatisfied, WhatTheModelCanNotNameIsFalse) {
  const Model model = pddl::samples::tea();
  const AtomSet state(model.init.begin(), model.init.end());
  EXPECT_EQ(unsatisfied(model, state, literals("(handempty) (not (hot pot)) (not (flying pot))")),
            std::vector<Literal>{});
  EXPECT_EQ(unsatisfied(model, state, literals("(hot pot) (handempty) (flying pot) (hot mug)")),
            literals("(hot pot) (flying pot) (hot mug)"))
      << "in the order given";
}

TEST(Fault, IsNothingForAValidPlan) {
  const Model model = pddl::samples::tea();
  EXPECT_EQ(fault(model, plan(kGood), model.goalLiterals()), std::nullopt);
  EXPECT_EQ(fault(model, {}, {}), std::nullopt);
}

TEST(Fault, NamesTheBrokenStepOrTheMissingGoals) {
  const Model model = pddl::samples::tea();
  EXPECT_EQ(fault(model, plan("(heat pot)"), {}),
            "step 1 (Heat Pot): the precondition (at Pot Table) is false");
  EXPECT_EQ(fault(model, {}, literals("(full mug) (handempty) (not (handempty))")),
            "the plan runs, but ends without the goal (full Mug) (not (HandEmpty))");
}

/// Blocks on a table as plain sets: another way to the same states.
struct Towers {
  std::set<std::string> facts{"(clear a)", "(clear b)", "(clear c)", "(table a)",
                              "(table b)", "(table c)", "(free)"};

  bool has(const std::string& fact) const { return facts.count(fact) > 0; }

  bool lift(const std::string& x) {
    if (!has("(clear " + x + ")") || !has("(table " + x + ")") || !has("(free)")) return false;
    for (const std::string& fact :
         {"(clear " + x + ")", "(table " + x + ")", std::string("(free)")}) {
      facts.erase(fact);
    }
    facts.insert("(held " + x + ")");
    return true;
  }

  bool put(const std::string& x, const std::string& y) {
    if (!has("(held " + x + ")") || !has("(clear " + y + ")")) return false;
    facts.erase("(held " + x + ")");
    facts.erase("(clear " + y + ")");
    facts.insert({"(clear " + x + ")", "(on " + x + " " + y + ")", "(free)"});
    return true;
  }
};

Model towers() {
  return pddl::readModel({"d", R"((define (domain d)
        (:predicates (clear ?x) (table ?x) (held ?x) (on ?x ?y) (free))
        (:action lift :parameters (?x) :precondition (and (clear ?x) (table ?x) (free))
          :effect (and (not (clear ?x)) (not (table ?x)) (not (free)) (held ?x)))
        (:action put :parameters (?x ?y) :precondition (and (held ?x) (clear ?y))
          :effect (and (not (held ?x)) (not (clear ?y)) (clear ?x) (on ?x ?y) (free)))))"},
                         {"p", R"((define (problem p) (:domain d) (:objects a b c) (:goal ())
        (:init (clear a) (clear b) (clear c) (table a) (table b) (table c) (free))))"});
}

RC_GTEST_PROP(Execute, AgreesWithAPlainSimulation, ()) {
  const auto block = rc::gen::elementOf(std::vector<std::string>{"a", "b", "c"});
  const Model model = towers();
  Towers expected;
  std::vector<GroundName> steps;
  bool runs = true;
  for (int i = 0; i < 5 && runs; ++i) {
    const std::string x = *block;
    const std::string y = *block;
    const bool lifts = i % 2 == 0;
    steps.push_back(lifts ? GroundName{"lift", {x}} : GroundName{"put", {x, y}});
    runs = lifts ? expected.lift(x) : expected.put(x, y);
  }
  const Execution execution = execute(model, steps);
  RC_ASSERT(execution.violation.has_value() == !runs);
  std::set<std::string> facts;
  for (const pddl::Atom& atom : execution.finalState())
    facts.insert(model.name(atom).text());
  RC_ASSERT(facts == expected.facts);
}

}  // namespace
}  // namespace goal_alignment::validation
