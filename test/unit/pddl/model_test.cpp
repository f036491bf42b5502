// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/model.h"

#include <gtest/gtest.h>

#include <string>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/parser.h"
#include "unit/pddl/samples.h"

namespace goal_alignment::pddl {
namespace {

std::string whyNot(const std::string& atom) {
  std::string why_not;
  const bool resolved = samples::tea().resolve(GroundName::parse(atom), &why_not).has_value();
  return resolved ? "resolved" : why_not;
}

TEST(ReadModel, StopsAtACancelAndAtTheDeadline) {
  const Source domain{"d.pddl", samples::kTeaDomain};
  const Source problem{"p.pddl", samples::kTeaProblem};
  CancelToken token;
  Limits limits;
  limits.cancel = &token;
  EXPECT_EQ(readModel(domain, problem, limits).init, samples::tea().init);
  token.cancel();
  try {
    readModel(domain, problem, limits);
    FAIL() << "read to its end";
  } catch (const LimitReached& stopped) {
    EXPECT_EQ(stopped.reason(), LimitReason::Cancelled);
  }
  EXPECT_THROW(readModel(domain, problem, Limits{}.withSeconds(0)), LimitReached);
  const ast::Domain domain_ast = parseDomain(domain);
  const ast::Problem problem_ast = parseProblem(problem);
  EXPECT_THROW(link(domain_ast, problem_ast, limits), LimitReached);
}

TEST(Model, FindsByLowerCaseName) {
  const Model model = samples::tea();
  ASSERT_TRUE(model.findObject("pot"));
  EXPECT_EQ(model.objects[*model.findObject("pot")].name.spelling, "Pot");
  EXPECT_EQ(model.schemas[*model.findSchema("pour")].parameters.size(), 2U);
  EXPECT_FALSE(model.findObject("Pot"));
  EXPECT_FALSE(model.findPredicate("heat"));
  EXPECT_FALSE(model.findSchema("hot"));
}

TEST(Model, ResolvesAndNamesAtoms) {
  const Model model = samples::tea();
  const GroundName name = GroundName::parse("(at Pot SHELF)");
  const auto atom = model.resolve(name);
  ASSERT_TRUE(atom);
  EXPECT_EQ(model.name(*atom), name);
  EXPECT_EQ(model.init[1], *atom);
}

TEST(Model, SaysWhyAnAtomDoesNotResolve) {
  EXPECT_EQ(whyNot("(at pot shelf)"), "resolved");
  EXPECT_EQ(whyNot("(handempy)"), "unknown predicate 'handempy'; did you mean 'handempty'?");
  EXPECT_EQ(whyNot("(hot kettle)"), "unknown object 'kettle'");
  EXPECT_EQ(whyNot("(hot pot shelf)"), "'hot' takes 1 argument, found 2");
  EXPECT_EQ(whyNot("(hot mug)"), "'Mug' is of type 'cup', but 'hot' takes 'kettle' there");
  EXPECT_FALSE(samples::tea().resolve(GroundName::parse("(hot mug)")));
}

TEST(Model, SpellsNamesAsTheyWereWritten) {
  const Model model = samples::tea();
  EXPECT_EQ(model.spelling(GroundName::parse("(handempty)")), "(HandEmpty)");
  EXPECT_EQ(model.spelling(GroundName::parse("(heat pot)")), "(Heat Pot)");
  EXPECT_EQ(model.spelling(GroundName::parse("(fly mug moon)")), "(fly Mug moon)");
}

TEST(Model, TakesANewGoal) {
  Model model = samples::tea();
  const std::vector<Literal> goal{Literal::parse("(full glass)"),
                                  Literal::parse("(not (hot pot))")};
  model.setGoal(goal);
  EXPECT_EQ(model.goalLiterals(), goal);
}

TEST(Model, RefusesAGoalThatDoesNotFitAndKeepsTheOldOne) {
  Model model = samples::tea();
  const std::vector<Literal> before = model.goalLiterals();
  const std::string message = samples::errorOf<SemanticError>([&] {
    model.setGoal({Literal::parse("(full glass)"), Literal::parse("(full tea)")});
  });
  EXPECT_EQ(message, "two-cups.pddl: the goal (full tea): unknown object 'tea'");
  EXPECT_EQ(model.goalLiterals(), before);
}

TEST(AtomHash, TellsArgumentsApart) {
  const AtomHash hash;
  EXPECT_EQ(hash(Atom{1, {2, 3}}), hash(Atom{1, {2, 3}}));
  EXPECT_NE(hash(Atom{1, {2, 3}}), hash(Atom{1, {3, 2}}));
  EXPECT_NE(hash(Atom{0, {}}), hash(Atom{1, {}}));
  EXPECT_NE(hash(Atom{0, {0}}), hash(Atom{0, {0, 0}}));
}

}  // namespace
}  // namespace goal_alignment::pddl
