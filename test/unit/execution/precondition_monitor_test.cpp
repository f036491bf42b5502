// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/precondition_monitor.h"

#include <gtest/gtest.h>

namespace goal_alignment::execution {
namespace {

using Verdict = PreconditionMonitor::Verdict;

constexpr const char* kDomain = R"((define (domain d) (:requirements :adl)
  (:predicates (at ?r) (dark ?r) (has ?t) (wet ?t))
  (:action go :parameters (?a ?b) :precondition (and (at ?a) (not (dark ?b)))
    :effect (and (at ?b) (not (at ?a)) (forall (?t) (when (has ?t) (wet ?t)))))
  (:action search :parameters (?r) :precondition (or (dark ?r) (at ?r)) :effect (has ?r))))";
constexpr const char* kProblem =
    "(define (problem p) (:domain d) (:objects hall den cup) (:init) (:goal (at den)))";

GroundName atom(const std::string& text) {
  return GroundName::parse(text);
}

class Watch : public testing::Test {
 protected:
  Verdict verdict(const std::string& action, const WorldState& world) {
    const auto finding = watch_.precondition(atom(action), world);
    reason_ = finding.reason;
    return finding.verdict;
  }

  PreconditionMonitor watch_{pddl::readModel({"d", kDomain}, {"p", kProblem})};
  std::string reason_;
};

TEST_F(Watch, knowsWhetherAPreconditionHolds) {
  EXPECT_EQ(verdict("go hall den", {{atom("at hall")}, {}}), Verdict::Holds);
  EXPECT_EQ(verdict("go hall den", {{}, {}}), Verdict::False);
  EXPECT_EQ(reason_, "the precondition (at hall) is false");
  EXPECT_EQ(verdict("go hall den", {{atom("at hall"), atom("dark den")}, {}}), Verdict::False);
}

TEST_F(Watch, doesNotTakeTheUnknownForFalse) {
  EXPECT_EQ(verdict("go hall den", {{}, {atom("at hall")}}), Verdict::Unknown);
  EXPECT_EQ(reason_, "nobody knows whether (at hall) holds");
  EXPECT_EQ(verdict("go hall den", {{atom("at hall")}, {atom("dark den")}}), Verdict::Unknown);
  EXPECT_EQ(verdict("go hall den", {{atom("at hall")}, {atom("has cup")}}), Verdict::Holds)
      << "what does not matter may be unknown";
  EXPECT_EQ(verdict("search den", {{}, {atom("at den")}}), Verdict::Unknown);
  EXPECT_EQ(verdict("search den", {{atom("dark den")}, {atom("at den")}}), Verdict::Holds);
  EXPECT_EQ(verdict("go hall den", {{}, {atom("dark den")}}), Verdict::False);
}

TEST_F(Watch, leavesAlonePlansAndFactsOfOtherModels) {
  EXPECT_EQ(verdict("fly", {{}, {}}), Verdict::NoModel);
  EXPECT_EQ(verdict("go hall moon", {{}, {}}), Verdict::NoModel);
  EXPECT_EQ(verdict("go hall den", {{atom("at moon")}, {}}), Verdict::NoModel);
  EXPECT_EQ(reason_, "the robot's model does not know the fact (at moon)");
}

TEST_F(Watch, tellsWhatASuccessChanges) {
  const auto changes =
      watch_.effects(atom("go hall den"), {{atom("at hall"), atom("has cup")}, {}});
  std::string text;
  for (const Literal& change : changes)
    text += change.text();
  EXPECT_EQ(text, "(at den)(not (at hall))(wet cup)");
  EXPECT_TRUE(watch_.effects(atom("go hall den"), {{}, {}}).empty()) << "it can't have happened";
}

TEST_F(Watch, knowsWhetherThePromisedHolds) {
  const std::vector<Literal> wanted = {{atom("at den"), false}, {atom("dark den"), true}};
  EXPECT_EQ(watch_.literals(wanted, {{atom("at den")}, {}}).verdict, Verdict::Holds);
  EXPECT_EQ(watch_.literals(wanted, {{}, {}}).reason, "(at den) does not hold");
  EXPECT_EQ(watch_.literals(wanted, {{atom("at den")}, {atom("dark den")}}).verdict,
            Verdict::Unknown);
  EXPECT_EQ(watch_.literals(wanted, {{}, {atom("dark den")}}).verdict, Verdict::False);
}

TEST_F(Watch, foreseesWhatTheRestOfAPlanComesTo) {
  const auto rest = [&](const WorldState& world, const std::vector<Literal>& wanted) {
    return watch_.rest({atom("search hall"), atom("go hall den"), atom("search den")}, wanted,
                       world);
  };
  const std::vector<Literal> wanted = {{atom("has den"), false}, {atom("wet hall"), false}};
  EXPECT_EQ(rest({{atom("at hall")}, {}}, wanted).verdict, Verdict::Holds);
  const auto blocked = rest({{atom("at hall"), atom("dark den")}, {}}, wanted);
  EXPECT_EQ(blocked.verdict, Verdict::False);
  EXPECT_EQ(blocked.step, 1U);
  EXPECT_EQ(blocked.reason, "the precondition (not (dark den)) is false");
  const auto dry = rest({{atom("at hall")}, {}}, {{atom("wet cup"), false}});
  EXPECT_EQ(dry.verdict, Verdict::False);
  EXPECT_EQ(dry.step, 3U) << "the end";
  EXPECT_EQ(dry.reason, "(wet cup) would not hold");
  EXPECT_EQ(watch_.rest({atom("fly")}, {}, {}).verdict, Verdict::NoModel);
}

TEST_F(Watch, believesOfTheUnknownWhatTheRestNeeds) {
  const auto verdictOf = [&](const WorldState& world, const std::vector<Literal>& wanted) {
    return watch_.rest({atom("go hall den"), atom("go den cup")}, wanted, world).verdict;
  };
  EXPECT_EQ(verdictOf({{}, {atom("at hall"), atom("dark den"), atom("dark cup")}}, {}),
            Verdict::Holds)
      << "one true, the others false";
  EXPECT_EQ(verdictOf({{atom("at hall")}, {atom("has hall")}}, {{atom("wet hall"), false}}),
            Verdict::Holds)
      << "it decides what a step changes";
  EXPECT_EQ(verdictOf({{atom("at hall")}, {atom("dark den")}}, {{atom("dark den"), false}}),
            Verdict::False)
      << "not both";
  EXPECT_EQ(verdictOf({{}, {atom("dark den")}}, {}), Verdict::False);
}

TEST_F(Watch, tellsWhatASuccessChangesInAnyCase) {
  std::string text;
  for (const Literal& change : watch_.certainEffects(atom("go hall den")))
    text += change.text();
  EXPECT_EQ(text, "(at den)(not (at hall))");
  text.clear();
  for (const Literal& change : watch_.certainEffects(atom("go hall hall")))
    text += change.text();
  EXPECT_EQ(text, "(at hall)") << "what is added stays";
  EXPECT_TRUE(watch_.certainEffects(atom("fly hall")).empty());
  EXPECT_TRUE(watch_.certainEffects(atom("go hall")).empty());
}

TEST(WorldState, changesInOrder) {
  WorldState world{{atom("at hall"), atom("wet cup")}, {atom("dark den")}};
  world.apply({{atom("dark den"), false}, {atom("at hall"), true}, {atom("wet cup"), false}});
  EXPECT_TRUE((world == WorldState{{atom("dark den"), atom("wet cup")}, {}}));
}

}  // namespace
}  // namespace goal_alignment::execution
