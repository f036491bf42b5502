// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/grounding/rules.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::grounding {
namespace {

pddl::Model modelOf(const std::string& action) {
  return pddl::readModel(
      {"d.pddl",
       "(define (domain d) (:types t none) (:predicates (p ?x) (q ?x) (r))"
       "(:action go :parameters (?x) " +
           action + "))"},
      {"p.pddl", "(define (problem p) (:domain d) (:objects a b - t) (:goal (and)))"});
}

TEST(CompileRules, AConjunctionIsOneRule) {
  const pddl::Model model =
      modelOf(":precondition (and (p ?x) (not (q ?x)) (not (= ?x a))) :effect (r)");
  const std::vector<Rule> rules = compileRules(model, {});
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_EQ(rules[0].effect, Rule::kAction);
  EXPECT_EQ(rules[0].body.size(), 1U);
  EXPECT_EQ(rules[0].absent.size(), 1U);
  EXPECT_EQ(rules[0].equalities.size(), 1U);
  EXPECT_EQ(rules[0].head.size(), 1U);
}

TEST(CompileRules, DisjunctionsAreDistributedAndWitnessesBound) {
  const pddl::Model model = modelOf(
      ":precondition (and (p ?x) (or (r) (exists (?y - t) (and (q ?y) (or (p ?y) (r)))))) :effect "
      "(r)");
  const std::vector<Rule> rules = compileRules(model, {});
  ASSERT_EQ(rules.size(), 3U);
  EXPECT_EQ(rules[0].variables, std::vector<int>{0});
  EXPECT_EQ(rules[1].variables, (std::vector<int>{0, 1}));
  EXPECT_EQ(rules[1].body.size(), 3U);
}

TEST(CompileRules, WitnessesThatOccurNowhereNeedToExist) {
  const pddl::Model some = modelOf(":precondition (exists (?y - t) (p ?x)) :effect (r)");
  ASSERT_EQ(compileRules(some, {}).size(), 1U);
  EXPECT_EQ(compileRules(some, {})[0].variables, std::vector<int>{0});
  EXPECT_TRUE(
      compileRules(modelOf(":precondition (exists (?y - none) (p ?x)) :effect (r)"), {}).empty());
}

TEST(CompileRules, UniversalConditionsAndTooManyAlternativesAreLeft) {
  const pddl::Model all = modelOf(":precondition (forall (?y) (p ?y)) :effect (r)");
  ASSERT_EQ(compileRules(all, {}).size(), 1U);
  EXPECT_EQ(compileRules(all, {})[0].residual.size(), 1U);
  std::string disjunctions;
  for (int i = 0; i < 7; ++i)
    disjunctions += " (or (p ?x) (q ?x))";
  const pddl::Model many = modelOf(":precondition (and" + disjunctions + ") :effect (r)");
  const std::vector<Rule> rules = compileRules(many, {});
  ASSERT_EQ(rules.size(), 64U);
  EXPECT_EQ(rules[0].body.size(), 6U);
  EXPECT_EQ(rules[0].residual.size(), 1U);
}

TEST(CompileRules, EffectsBeginWithTheirAction) {
  const pddl::Model model =
      modelOf(":effect (and (r) (forall (?y) (when (or (p ?y) (q ?x)) (q ?y))))");
  const std::vector<Rule> rules = compileRules(model, {});
  ASSERT_EQ(rules.size(), 3U);
  EXPECT_EQ(rules[0].head.back().predicate, reachedPredicate(model, 0));
  for (const std::size_t effect : {1U, 2U}) {
    EXPECT_EQ(rules[effect].effect, 0U);
    EXPECT_EQ(rules[effect].body.at(0).predicate, reachedPredicate(model, 0));
    EXPECT_EQ(rules[effect].variables, (std::vector<int>{0, 1}));
  }
}

TEST(CompileRules, StopsWhenCancelled) {
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(compileRules(modelOf(":precondition (exists (?y - t) (p ?y)) :effect (r)"), limits),
               LimitReached);
}

}  // namespace
}  // namespace goal_alignment::grounding
