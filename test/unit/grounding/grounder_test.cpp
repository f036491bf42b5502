// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/grounding/grounder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "oracles/lifted_space.h"
#include "oracles/random_pddl.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"
#include "samples.h"

namespace goal_alignment::grounding {
namespace {

using Kind = FactStatus::Kind;
using samples::named;
using samples::NamedOperator;
using samples::namedOperators;

Literal positive(const std::string& atom) {
  return {GroundName::parse(atom), false};
}
Literal negative(const std::string& atom) {
  return {GroundName::parse(atom), true};
}

/// What a naive ground action becomes, given which atoms can change and which have complements.
std::map<GroundName, NamedOperator> naiveOperators(const oracles::RelaxedGrounding& naive,
                                                   const std::set<Literal>& facts) {
  std::map<GroundName, NamedOperator> result;
  const auto changes = [&](const GroundName& atom) { return facts.count({atom, false}) > 0; };
  for (const oracles::GroundAction& action : naive.actions) {
    NamedOperator op;
    bool possible = true;
    for (const Literal& literal : action.precondition) {
      const bool reached = naive.atoms.count(literal.atom) > 0;
      if (!literal.negated && changes(literal.atom)) op.precondition.insert(literal);
      if (literal.negated && reached && !changes(literal.atom)) possible = false;
      if (literal.negated && reached && changes(literal.atom)) op.precondition.insert(literal);
    }
    for (const Literal& literal : op.precondition) {
      if (op.precondition.count({literal.atom, !literal.negated}) > 0) possible = false;
    }
    const auto effect = [&](const GroundName& atom, bool becomes) {
      if (!changes(atom)) return;
      (becomes ? op.add : op.del).insert({atom, false});
      if (facts.count({atom, true}) > 0) (becomes ? op.del : op.add).insert({atom, true});
    };
    for (const GroundName& atom : action.add)
      effect(atom, true);
    for (const GroundName& atom : action.del) {
      if (action.add.count(atom) == 0) effect(atom, false);
    }
    op.cost = action.cost;
    const bool idle =
        op.del.empty() &&
        std::includes(op.precondition.begin(), op.precondition.end(), op.add.begin(), op.add.end());
    if (possible && !idle) result[action.name] = op;
  }
  return result;
}

/// The facts a task should have: atoms that may change, and complements where somebody asks.
std::set<Literal> naiveFacts(const oracles::RelaxedGrounding& naive, const oracles::Atoms& initial,
                             const std::vector<Literal>& asked) {
  std::set<Literal> facts;
  for (const GroundName& atom : naive.atoms) {
    if (initial.count(atom) == 0) facts.insert({atom, false});
  }
  for (const oracles::GroundAction& action : naive.actions) {
    for (const GroundName& atom : action.del) {
      const bool known = naive.atoms.count(atom) > 0;
      if (known && action.add.count(atom) == 0) facts.insert({atom, false});
    }
  }
  const auto complement = [&](const Literal& literal) {
    if (literal.negated && facts.count({literal.atom, false}) > 0) facts.insert(literal);
  };
  for (const oracles::GroundAction& action : naive.actions) {
    for (const Literal& literal : action.precondition)
      complement(literal);
  }
  for (const Literal& literal : asked)
    complement(literal);
  return facts;
}

std::vector<Literal> someNegations(RandomSource& random, const oracles::ModelSketch& sketch) {
  std::vector<Literal> literals;
  for (const auto& predicate : sketch.predicates) {
    for (const std::string& atom : sketch.atomsOf(predicate)) {
      if (oracles::chance(random, 0.3)) literals.push_back(negative(atom));
    }
  }
  return literals;
}

RC_GTEST_PROP(Grounder, EqualsNaiveGrounding, ()) {
  RandomSource random = oracles::anySource();
  const oracles::ModelSketch sketch = oracles::randomSketch(random);
  const pddl::Model model = sketch.model();
  RC_LOG() << sketch.domainText() << sketch.problemText();
  const std::vector<Literal> asked = someNegations(random, sketch);
  const GroundTask ground = grounding::ground(model, asked, {false}, {});

  const oracles::Atoms initial = oracles::initialAtoms(model);
  const oracles::RelaxedGrounding naive = oracles::groundNaively(model);
  const std::set<Literal> facts = naiveFacts(naive, initial, asked);
  RC_ASSERT(std::set<Literal>(ground.task.facts.begin(), ground.task.facts.end()) == facts);
  RC_ASSERT(ground.task.facts.size() == facts.size());
  std::set<Literal> initially;
  for (const Literal& fact : facts) {
    if (oracles::holds({fact}, initial)) initially.insert(fact);
  }
  RC_ASSERT(named(ground.task, ground.task.initial) == initially);
  RC_ASSERT(std::is_sorted(ground.task.initial.begin(), ground.task.initial.end()));
  RC_ASSERT(namedOperators(ground.task) == naiveOperators(naive, facts));
  RC_ASSERT(namedOperators(ground.task).size() == ground.task.operators.size());
}

RC_GTEST_PROP(Grounder, OperatorsAreWellFormed, ()) {
  RandomSource random = oracles::anySource();
  const pddl::Model model = oracles::randomSketch(random).model();
  const GroundTask ground = grounding::ground(model, {}, {}, {});
  for (const task::Operator& op : ground.task.operators) {
    for (const task::FactSet* set : {&op.precondition, &op.add, &op.del}) {
      RC_ASSERT(*set == task::makeFactSet(*set));
    }
    for (const task::FactId fact : op.add) {
      RC_ASSERT(!std::binary_search(op.del.begin(), op.del.end(), fact));
    }
    RC_ASSERT(op.cost == 1);  // unit costs are the default
  }
}

// The grounded task and the lifted model have the same states, told in the facts of the task.
RC_GTEST_PROP(Grounder, KeepsTheStateSpace, ()) {
  RandomSource random = oracles::anySource();
  const oracles::ModelSketch sketch = oracles::randomSmallSketch(random, 300);
  const pddl::Model model = sketch.model();
  RC_LOG() << sketch.domainText() << sketch.problemText();
  const std::vector<Literal> asked = someNegations(random, sketch);
  const GroundTask ground = grounding::ground(model, asked, {}, {});
  std::set<oracles::Facts> expected;
  for (const oracles::Atoms& atoms : oracles::LiftedSpace(model, 300).states()) {
    oracles::Facts facts;
    for (task::FactId fact = 0; fact < ground.task.facts.size(); ++fact) {
      if (oracles::holds({ground.task.facts[fact]}, atoms)) facts.insert(fact);
    }
    expected.insert(facts);
  }
  std::set<oracles::Facts> found;
  for (const auto& [facts, cost] :
       oracles::reachable(ground.task, oracles::initialFacts(ground.task))) {
    found.insert(facts);
  }
  RC_ASSERT(found == expected);
}

RC_GTEST_PROP(Grounder, StatusIsSoundInEveryReachableState, ()) {
  RandomSource random = oracles::anySource();
  const oracles::ModelSketch sketch = oracles::randomSmallSketch(random, 300);
  const pddl::Model model = sketch.model();
  const std::vector<Literal> asked = someNegations(random, sketch);
  const GroundTask ground = grounding::ground(model, asked, {}, {});
  const std::vector<oracles::Atoms> states = oracles::LiftedSpace(model, 300).states();
  for (const auto& predicate : sketch.predicates) {
    for (const std::string& atom : sketch.atomsOf(predicate)) {
      RC_ASSERT(samples::sound(ground, positive(atom), states));
    }
  }
  for (const Literal& literal : asked)
    RC_ASSERT(samples::sound(ground, literal, states));
}

RC_GTEST_PROP(Grounder, ComplementsStayConsistentAlongRandomWalks, ()) {
  RandomSource random = oracles::anySource();
  const oracles::ModelSketch sketch = oracles::randomSketch(random);
  const pddl::Model model = sketch.model();
  const GroundTask ground = grounding::ground(model, someNegations(random, sketch), {}, {});
  std::map<Literal, task::FactId> ids;
  for (task::FactId fact = 0; fact < ground.task.facts.size(); ++fact) {
    ids[ground.task.facts[fact]] = fact;
  }
  oracles::Facts state = oracles::initialFacts(ground.task);
  for (int step = 0; step < 30; ++step) {
    for (const auto& [literal, fact] : ids) {
      if (!literal.negated) continue;
      RC_ASSERT(state.count(fact) != state.count(ids.at({literal.atom, false})));
    }
    const auto applicable = oracles::applicableOperators(ground.task, state);
    if (applicable.empty()) break;
    const task::OperatorId op = applicable[random.below(applicable.size())];
    state = oracles::successor(ground.task.operators[op], state);
  }
}

const char* const kRooms = R"((define (domain rooms)
  (:types robot room)
  (:predicates (in ?r - robot ?x - room) (lit ?x - room) (wall ?x - room) (broken ?r - robot))
  (:functions (total-cost) (way ?x ?y - room))
  (:action move :parameters (?r - robot ?x ?y - room)
    :precondition (and (in ?r ?x) (not (wall ?y)) (not (= ?x ?y)) (not (broken ?r)))
    :effect (and (in ?r ?y) (not (in ?r ?x)) (increase (total-cost) (way ?x ?y))))
  (:action stay :parameters (?r - robot ?x - room)
    :precondition (in ?r ?x) :effect (and (in ?r ?x) (not (in ?r ?x))))))";
const char* const kThreeRooms = R"((define (problem three) (:domain rooms)
  (:objects R2 - robot A B C - room)
  (:init (in R2 A) (wall C) (lit A) (= (way A B) 4) (= (way B A) 5))
  (:goal (in R2 B)) (:metric minimize (total-cost))))";

pddl::Model rooms() {
  return pddl::readModel({"d.pddl", kRooms}, {"p.pddl", kThreeRooms});
}

TEST(Grounder, TellsWhatALiteralIs) {
  const pddl::Model model = rooms();
  const GroundTask ground = grounding::ground(model, {negative("(in r2 a)")}, {}, {});
  const auto kind = [&](const Literal& literal) { return ground.status(literal).kind; };
  EXPECT_EQ(kind(positive("(in r2 b)")), Kind::Variable);
  EXPECT_EQ(kind(negative("(in r2 a)")), Kind::Variable);
  EXPECT_EQ(kind(positive("(lit a)")), Kind::AlwaysTrue);
  EXPECT_EQ(kind(negative("(lit a)")), Kind::NeverTrue);
  EXPECT_EQ(kind(negative("(lit b)")), Kind::AlwaysTrue);
  EXPECT_EQ(kind(positive("(lit b)")), Kind::NeverTrue);
  EXPECT_EQ(kind(positive("(in r2 c)")), Kind::NeverTrue);
  for (const char* unknown : {"(on a b)", "(in r2 d)", "(lit)", "(lit r2)"}) {
    EXPECT_EQ(kind(positive(unknown)), Kind::Unknown) << unknown;
    EXPECT_EQ(kind(negative(unknown)), Kind::AlwaysTrue) << unknown;
  }
}

// No fact says whether r2 is in b, and no other answer would be right.
TEST(Grounder, RefusesANegationThatItWasNotAskedFor) {
  const pddl::Model model = rooms();
  const GroundTask ground = grounding::ground(model, {negative("(in r2 a)")}, {}, {});
  EXPECT_THROW(ground.status(negative("(in r2 b)")), std::logic_error);
  EXPECT_THROW(ground.goal({negative("(in r2 a)"), negative("(in r2 b)")}), std::logic_error);
  EXPECT_EQ(ground.goal({negative("(in r2 a)"), negative("(in r2 c)")}).alternatives.size(), 1U);
}

// `stay` deletes and adds the same atom: the add wins, so nothing changes.
TEST(Grounder, LeavesOutOperatorsThatChangeNothing) {
  const pddl::Model model = rooms();
  std::set<std::string> names;
  for (const task::Operator& op : grounding::ground(model, {}, {}, {}).task.operators) {
    names.insert(op.name.text());
  }
  EXPECT_EQ(names, (std::set<std::string>{"(move r2 a b)", "(move r2 b a)"}));
}

TEST(Grounder, CostsAreTheMetricsUnlessUnitCostsAreWanted) {
  const pddl::Model model = rooms();
  const auto with_costs = namedOperators(grounding::ground(model, {}, {false}, {}).task);
  EXPECT_EQ(with_costs.at({"move", {"r2", "b", "a"}}).cost, 5);
  const auto unit = namedOperators(grounding::ground(model, {}, {true}, {}).task);
  EXPECT_EQ(unit.at({"move", {"r2", "b", "a"}}).cost, 1);
}

TEST(Grounder, NamesTheMissingCost) {
  std::string problem = kThreeRooms;
  problem.erase(problem.find(" (= (way B A) 5)"), 16);
  const pddl::Model model = pddl::readModel({"d.pddl", kRooms}, {"p.pddl", problem});
  EXPECT_NO_THROW(grounding::ground(model, {}, {true}, {}));
  try {
    grounding::ground(model, {}, {false}, {});
    FAIL() << "an action without a cost was grounded";
  } catch (const pddl::SemanticError& error) {
    EXPECT_NE(std::string(error.what()).find("(way B A)"), std::string::npos) << error.what();
  }
}

TEST(Grounder, StopsWhenCancelled) {
  const pddl::Model model = rooms();
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(grounding::ground(model, {}, {}, limits), LimitReached);
}

}  // namespace
}  // namespace goal_alignment::grounding
