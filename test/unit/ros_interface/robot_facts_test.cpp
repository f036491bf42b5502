// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/robot_facts.h"

#include <gtest/gtest.h>

namespace goal_alignment::ros_interface {
namespace {

pddl::Model hall() {
  return pddl::readModel(
      {"domain", "(define (domain d) (:predicates (clean ?r) (lit ?r)))"},
      {"problem",
       "(define (problem q) (:domain d) (:objects hall attic) (:init (clean hall)) "
       "(:goal (clean hall)))"});
}

Fluent fact(const std::string& name, const std::vector<std::string>& args, bool negated = false) {
  Fluent message;
  message.name = name;
  message.args = args;
  message.negated = negated;
  return message;
}

std::vector<GroundName> names(const std::vector<std::string>& texts) {
  std::vector<GroundName> result;
  for (const std::string& text : texts)
    result.push_back(GroundName::parse(text));
  return result;
}

std::vector<GroundName> stateOf(const RobotFacts& facts, std::vector<GroundName>* left_out = {}) {
  std::vector<GroundName> ignored;
  return facts.state(left_out != nullptr ? *left_out : ignored);
}

TEST(RobotFacts, addAndRetract) {
  RobotFacts facts;
  facts.setModel(hall());
  EXPECT_EQ(stateOf(facts), names({"(clean hall)"}));
  const unsigned before = facts.version();
  EXPECT_TRUE(facts.set({fact("Lit", {"HALL"}), fact("clean", {"hall"}, true)}).accepted);
  EXPECT_NE(facts.version(), before);
  EXPECT_EQ(stateOf(facts), names({"(lit hall)"}));
  EXPECT_TRUE(facts.set({fact("lit", {"hall"}, true)}).accepted);
  EXPECT_TRUE(stateOf(facts).empty());
}

TEST(RobotFacts, areTakenAllOrNone) {
  RobotFacts facts;
  facts.setModel(hall());
  const auto refused = [&](const std::vector<Fluent>& given, const std::string& what) {
    const auto receipt = facts.set(given);
    EXPECT_FALSE(receipt.accepted);
    EXPECT_NE(receipt.message.find(what), std::string::npos) << receipt.message;
    EXPECT_EQ(stateOf(facts), names({"(clean hall)"}));
  };
  refused({}, "no fact");
  refused({fact("lit", {"hall"}), fact("dark", {"hall"})}, "facts[1]");
  refused({fact("lit", {"cellar"})}, "cellar");
  refused({fact("lit", {})}, "takes 1 argument");
  refused({fact("lit", {"hall"}), fact("lit", {"hall"}, true)}, "both true and false");
  refused({fact("l it", {})}, "no PDDL name");
  refused({fact("", {})}, "empty");
}

TEST(RobotFacts, ofEarlierSessionsHoldWhereAsked) {
  RobotFacts facts;
  EXPECT_TRUE(facts.set({fact("lit", {"hall"})}).accepted) << "no model is known yet";
  facts.beginSession("one", false);
  facts.setModel(hall());
  EXPECT_EQ(stateOf(facts), names({"(clean hall)"})) << "the goal brings its own state";
  EXPECT_TRUE(facts.set({fact("lit", {"attic"})}).accepted);
  EXPECT_EQ(stateOf(facts), names({"(clean hall)", "(lit attic)"}));
  facts.beginSession("two", true);
  facts.setModel(hall());
  EXPECT_EQ(stateOf(facts), names({"(clean hall)", "(lit attic)", "(lit hall)"}));
}

TEST(RobotFacts, thatAnotherModelDoesNotKnowAreNamed) {
  RobotFacts facts;
  facts.set({fact("lit", {"cellar"}), fact("lit", {"hall"})});
  facts.beginSession("one", true);
  facts.setModel(hall());
  std::vector<GroundName> left_out;
  EXPECT_EQ(stateOf(facts, &left_out), names({"(clean hall)", "(lit hall)"}));
  EXPECT_EQ(left_out, names({"(lit cellar)"}));
}

TEST(RobotFacts, areTold) {
  RobotFacts facts;
  EXPECT_FALSE(facts.tell().known);
  EXPECT_EQ(facts.tell().message, "no task was given yet");
  facts.beginSession("one", true);
  EXPECT_FALSE(facts.tell().known);
  EXPECT_EQ(facts.tell().session_id, "one");
  EXPECT_FALSE(facts.tell().message.empty());
  facts.setModel(hall());
  facts.set({fact("lit", {"attic"})});
  const GetFacts::Response told = facts.tell();
  EXPECT_TRUE(told.known);
  EXPECT_EQ(told.session_id, "one");
  ASSERT_EQ(told.facts.size(), 2U);
  EXPECT_EQ(told.facts[0].name, "clean");
  EXPECT_EQ(told.facts[1].args, std::vector<std::string>{"attic"});
  EXPECT_TRUE(told.unknown.empty());
}

}  // namespace
}  // namespace goal_alignment::ros_interface
