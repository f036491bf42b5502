// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/said_facts.h"

#include <gtest/gtest.h>

#include <string>

namespace goal_alignment::aligner {
namespace {

GroundName atom(const std::string& text) {
  return GroundName::parse(text);
}

// "(p) (not (q))r": those that the robot reported end with an r.
std::string believed(const SaidFacts& facts, bool follows = true) {
  std::string text;
  for (const session::HumanFact& each : facts.ofHuman(follows))
    text += (text.empty() ? "" : " ") + each.fact.text() + (each.of_robot ? "r" : "");
  return text;
}

TEST(SaidFacts, thePersonFollowsWhatTheRobotReports) {
  SaidFacts facts;
  EXPECT_TRUE(facts.setRobot(atom("(in-box duck)"), true, false));
  EXPECT_TRUE(facts.setRobot(atom("(at duck hall)"), false, false));
  EXPECT_EQ(believed(facts), "(not (at duck hall))r (in-box duck)r");
  EXPECT_EQ(believed(facts, false), "");
}

TEST(SaidFacts, ofOneAtomTheLaterWordCountsForThePerson) {
  SaidFacts facts;
  facts.setRobot(atom("(p)"), true, false);
  EXPECT_TRUE(facts.setHuman(atom("(p)"), false));
  EXPECT_EQ(believed(facts), "(not (p))");
  EXPECT_FALSE(facts.setRobot(atom("(p)"), true, false)) << "a report that is repeated is no news";
  EXPECT_EQ(believed(facts), "(not (p))");
  EXPECT_TRUE(facts.setRobot(atom("(p)"), false, false));
  EXPECT_TRUE(facts.setRobot(atom("(p)"), true, false));
  EXPECT_EQ(believed(facts), "(p)r");
  EXPECT_EQ(believed(facts, false), "(not (p))") << "who does not follow was told nothing else";
  EXPECT_TRUE(facts.setHuman(atom("(p)"), false)) << "said again it overrules the report";
  EXPECT_FALSE(facts.setHuman(atom("(p)"), false));
  EXPECT_EQ(believed(facts), "(not (p))");
  EXPECT_EQ(facts.ofRobot().at(atom("(p)")), true) << "the robot knows what it knew";
}

TEST(SaidFacts, whatIsLeftToTfIsThePersonsAlone) {
  SaidFacts facts;
  EXPECT_TRUE(facts.setRobot(atom("(at robot hall)"), true, true));
  EXPECT_TRUE(facts.ofRobot().empty());
  EXPECT_EQ(believed(facts), "(at robot hall)r");
  EXPECT_TRUE(facts.setRobot(atom("(at robot hall)"), true, false)) << "tf no longer owns it";
  EXPECT_EQ(facts.ofRobot().size(), 1U);
}

TEST(SaidFacts, earlierOnesComeBeforeAllThatIsKnown) {
  SaidFacts earlier;
  earlier.setRobot(atom("(p)"), true, false);
  earlier.setRobot(atom("(q)"), true, false);
  earlier.setHuman(atom("(q)"), false);
  SaidFacts facts;
  facts.setHuman(atom("(p)"), false);
  facts.setRobot(atom("(q)"), false, false);
  facts.putBefore(SaidFacts(earlier.robot(), earlier.human()));
  EXPECT_EQ(facts.size(), 4U);
  EXPECT_EQ(facts.ofRobot().at(atom("(q)")), false);
  EXPECT_EQ(believed(facts), "(not (p)) (not (q))r");
  facts.setHuman(atom("(q)"), true);
  EXPECT_EQ(believed(facts), "(not (p)) (q)");
}

}  // namespace
}  // namespace goal_alignment::aligner
