// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/robot_facts.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace goal_alignment::aligner {
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
  return facts.state({}, left_out != nullptr ? *left_out : ignored);
}

TEST(RobotFacts, addAndRetract) {
  RobotFacts facts;
  facts.setModel(hall());
  EXPECT_EQ(stateOf(facts), names({"(clean hall)"}));
  const unsigned before = facts.version();
  EXPECT_TRUE(facts.set({fact("Lit", {"HALL"}), fact("clean", {"hall"}, true)}, nullptr).accepted);
  EXPECT_NE(facts.version(), before);
  EXPECT_EQ(stateOf(facts), names({"(lit hall)"}));
  EXPECT_TRUE(facts.set({fact("lit", {"hall"}, true)}, nullptr).accepted);
  EXPECT_TRUE(stateOf(facts).empty());
}

TEST(RobotFacts, areTakenAllOrNone) {
  RobotFacts facts;
  facts.setModel(hall());
  const auto refused = [&](const std::vector<Fluent>& given, const std::string& what) {
    const auto receipt = facts.set(given, nullptr);
    EXPECT_FALSE(receipt.accepted);
    EXPECT_NE(receipt.message.find(what), std::string::npos) << receipt.message;
    EXPECT_EQ(stateOf(facts), names({"(clean hall)"}));
  };
  refused({}, "no fact");
  refused({fact("lit", {"hall"}), fact("dark", {"hall"})}, "facts[1]");
  refused({fact("lit", {"cellar"})}, "cellar");
  refused({fact("lit", {})}, "takes 1 argument");
  refused({fact("lit", {"hall"}), fact("lit", {"hall"}, true)}, "both true and false");
  refused({fact("l it", {})}, "not a PDDL name");
  refused({fact("", {})}, "empty");
}

TEST(RobotFacts, ofEarlierSessionsHoldWhereAsked) {
  RobotFacts facts;
  EXPECT_TRUE(facts.set({fact("lit", {"hall"})}, nullptr).accepted) << "no model is known yet";
  facts.beginSession("one", false);
  facts.setModel(hall());
  EXPECT_EQ(stateOf(facts), names({"(clean hall)"})) << "the goal brings its own state";
  EXPECT_TRUE(facts.set({fact("lit", {"attic"})}, nullptr).accepted);
  EXPECT_EQ(stateOf(facts), names({"(clean hall)", "(lit attic)"}));
  facts.beginSession("two", true);
  facts.setModel(hall());
  EXPECT_EQ(stateOf(facts), names({"(clean hall)", "(lit attic)", "(lit hall)"}));
}

TEST(RobotFacts, thatAnotherModelDoesNotKnowAreNamed) {
  RobotFacts facts;
  facts.set({fact("lit", {"cellar"}), fact("lit", {"hall"})}, nullptr);
  facts.beginSession("one", true);
  facts.setModel(hall());
  std::vector<GroundName> left_out;
  EXPECT_EQ(stateOf(facts, &left_out), names({"(clean hall)", "(lit hall)"}));
  EXPECT_EQ(left_out, names({"(lit cellar)"}));
}

TEST(RobotFacts, areTold) {
  RobotFacts facts;
  EXPECT_FALSE(facts.tell({}).known);
  EXPECT_EQ(facts.tell({}).message, "no task was given yet");
  facts.beginSession("one", true);
  EXPECT_FALSE(facts.tell({}).known);
  EXPECT_EQ(facts.tell({}).session_id, "one");
  EXPECT_FALSE(facts.tell({}).message.empty());
  facts.setModel(hall());
  facts.set({fact("lit", {"attic"})}, nullptr);
  const GetFacts::Response told = facts.tell({});
  EXPECT_TRUE(told.known);
  EXPECT_EQ(told.session_id, "one");
  ASSERT_EQ(told.facts.size(), 2U);
  EXPECT_EQ(told.facts[0].name, "clean");
  EXPECT_EQ(told.facts[1].args, std::vector<std::string>{"attic"});
  EXPECT_TRUE(told.unknown.empty());
  EXPECT_TRUE(told.message.empty());
}

// (lit hall) comes from tf; it is so where the robot is at the switch.
spatial_facts::Observer switchRule(const std::string& unknown) {
  return spatial_facts::Observer(
      spatial_facts::Rules::fromYaml("frames: {robot: base_link}\n"
                                     "regions: {switch: {sphere: {radius: 1}}}\n"
                                     "rules: [{fact: (lit hall), when: robot in switch, unknown: " +
                                         unknown + "}]\n",
                                     "rules.yaml"));
}

spatial_facts::Sighting seenAt(double x) {
  spatial_facts::Sighting sighting;
  sighting.known = true;
  sighting.position.x = x;
  return sighting;
}

TEST(RobotFacts, thatWereSeenReplaceAllOthers) {
  RobotFacts facts;
  facts.beginSession("one", true);
  facts.setModel(hall());
  spatial_facts::Observer observer = switchRule("fail");
  std::vector<GroundName> left_out;
  EXPECT_EQ(facts.state(observer.observe({seenAt(0)}), left_out),
            names({"(clean hall)", "(lit hall)"}));
  // Set before there were rules.
  EXPECT_TRUE(facts.set({fact("lit", {"hall"})}, nullptr).accepted);
  EXPECT_EQ(facts.state(observer.observe({seenAt(9)}), left_out), names({"(clean hall)"}));
  EXPECT_EQ(facts.state({}, left_out), names({"(clean hall)", "(lit hall)"}));

  const GetFacts::Response blind = facts.tell(observer.observe({{}}));
  EXPECT_TRUE(blind.known);
  ASSERT_EQ(blind.facts.size(), 1U);
  ASSERT_EQ(blind.unknown.size(), 1U);
  EXPECT_EQ(blind.unknown[0].name, "lit");
  EXPECT_NE(blind.message.find("base_link"), std::string::npos) << blind.message;
}

TEST(RobotFacts, thatComeFromTfCannotBeSet) {
  RobotFacts facts;
  facts.beginSession("one", true);
  facts.setModel(hall());
  const auto strict = switchRule("fail").rules();
  const auto refused = facts.set({fact("lit", {"hall"}, true)}, strict.get());
  EXPECT_FALSE(refused.accepted);
  EXPECT_EQ(refused.message, "(lit hall) comes from tf (rules.yaml:3:16): it can't be set");
  const auto partly = facts.set({fact("lit", {"hall"}), fact("lit", {"attic"})}, strict.get());
  EXPECT_TRUE(partly.accepted);
  EXPECT_EQ(partly.message, "taken, but (lit hall) comes from tf (rules.yaml:3:16)");
  EXPECT_EQ(stateOf(facts), names({"(clean hall)", "(lit attic)"}));

  // What counts while tf can't tell may be set.
  spatial_facts::Observer trusting = switchRule("trust_file");
  const auto taken = facts.set({fact("lit", {"hall"})}, trusting.rules().get());
  EXPECT_TRUE(taken.accepted);
  EXPECT_TRUE(taken.message.empty());
  std::vector<GroundName> left_out;
  EXPECT_EQ(facts.state(trusting.observe({{}}), left_out),
            names({"(clean hall)", "(lit attic)", "(lit hall)"}));
  EXPECT_EQ(facts.state(trusting.observe({seenAt(9)}), left_out),
            names({"(clean hall)", "(lit attic)"}));
}

std::string believed(const RobotFacts& facts, bool follows = true) {
  std::string text;
  for (const session::HumanFact& each : facts.believed(follows))
    text += (text.empty() ? "" : " ") + each.fact.text();
  return text;
}

TEST(RobotFacts, areFollowedByThePersonAlsoWhereTfOwnsThem) {
  RobotFacts facts;
  facts.beginSession("one", true);
  facts.setModel(hall());
  const auto strict = switchRule("fail").rules();
  EXPECT_FALSE(facts.set({fact("lit", {"hall"})}, strict.get()).accepted);
  EXPECT_TRUE(facts.set({fact("clean", {"hall"}, true)}, strict.get()).accepted);
  EXPECT_FALSE(facts.set({fact("dark", {"hall"})}, strict.get()).accepted);
  EXPECT_EQ(believed(facts), "(not (clean hall)) (lit hall)");
  EXPECT_EQ(believed(facts, false), "");
}

TEST(RobotFacts, ofThePersonAreTakenAllOrNone) {
  RobotFacts facts;
  const pddl::Model human = hall();
  EXPECT_FALSE(facts.setHuman({}, &human).accepted);
  const auto refused = facts.setHuman({fact("lit", {"hall"}), fact("dark", {"hall"})}, &human);
  EXPECT_FALSE(refused.accepted);
  EXPECT_NE(refused.message.find("facts[1]: the person's model can't have (dark hall)"),
            std::string::npos)
      << refused.message;
  EXPECT_EQ(believed(facts), "");
  EXPECT_TRUE(facts.setHuman({fact("lit", {"hall"})}, &human).accepted);
  EXPECT_TRUE(facts.setHuman({fact("dark", {"hall"})}, nullptr).accepted) << "its model is unknown";
  EXPECT_EQ(believed(facts, false), "(dark hall) (lit hall)");
  facts.beginSession("one", true);
  facts.setModel(hall());
  EXPECT_EQ(stateOf(facts), names({"(clean hall)"})) << "the robot's world is as it was";
}

TEST(RobotFacts, areForgottenByTheSessionUnderWayAsWell) {
  RobotFacts facts;
  facts.beginSession("one", true);
  facts.setModel(hall());
  facts.set({fact("lit", {"hall"}), fact("clean", {"hall"}, true)}, nullptr);
  facts.setHuman({fact("lit", {"hall"})}, nullptr);
  const unsigned before = facts.version();
  EXPECT_EQ(facts.forget(), 3U);
  EXPECT_NE(facts.version(), before);
  EXPECT_EQ(stateOf(facts), names({"(clean hall)"}));
  EXPECT_EQ(believed(facts), "");
}

TEST(RobotFacts, areToldOfTheNextTaskBeforeThereIsOne) {
  RobotFacts facts;
  EXPECT_FALSE(facts.tellBefore(nullptr, "no file", {}).known);
  EXPECT_NE(facts.tellBefore(nullptr, "no file", {}).message.find("no file"), std::string::npos);
  facts.set({fact("lit", {"hall"}), fact("dark", {"hall"})}, nullptr);
  const auto told = facts.tellBefore(std::make_shared<const pddl::Model>(hall()), "", {});
  EXPECT_TRUE(told.known);
  EXPECT_EQ(told.session_id, "");
  ASSERT_EQ(told.facts.size(), 2U) << "what the model can't have is left out";
  EXPECT_EQ(told.facts[1].name, "lit");
}

class KeptRobotFacts : public testing::Test {
 protected:
  KeptRobotFacts()
      : folder_(std::filesystem::temp_directory_path() /
                ("robot_facts_test." + std::to_string(getpid()))) {}
  ~KeptRobotFacts() override { std::filesystem::remove_all(folder_); }

  // As after a restart.
  std::unique_ptr<FactFile> file() {
    return std::make_unique<FactFile>(folder_.string(), "/r",
                                      [](const std::string& line) { ADD_FAILURE() << line; });
  }

  static FactScope scope(const std::string& problem = "") {
    session::Input models;
    models.robot_problem.text = problem;
    return FactScope::of(models, "");
  }

  std::filesystem::path folder_;
};

TEST_F(KeptRobotFacts, holdAgainAfterARestartAndSaySoOnce) {
  const auto before = file();
  RobotFacts facts(before.get());
  EXPECT_EQ(facts.follow(scope(), 60), "");
  facts.set({fact("lit", {"hall"})}, nullptr);
  facts.setHuman({fact("lit", {"attic"})}, nullptr);

  const auto after = file();
  RobotFacts again(after.get());
  const std::string line = again.follow(scope(), 60);
  EXPECT_EQ(line.find("facts from before the restart (1 of the robot's world, 1 of what"), 0U)
      << line;
  EXPECT_EQ(again.follow(scope(), 60), "");
  again.beginSession("one", true);
  again.setModel(hall());
  EXPECT_EQ(stateOf(again), names({"(clean hall)", "(lit hall)"}));
  EXPECT_EQ(believed(again), "(lit attic) (lit hall)");

  EXPECT_EQ(again.forget(), 2U);
  const auto last = file();
  EXPECT_EQ(RobotFacts(last.get()).follow(scope(), 60), "");
}

TEST_F(KeptRobotFacts, thatWereSetBeforeTheModelsCouldBeReadAreKeptAfterThose) {
  const auto before = file();
  RobotFacts facts(before.get());
  facts.follow(scope(), 60);
  facts.set({fact("lit", {"hall"}), fact("lit", {"attic"})}, nullptr);

  const auto after = file();
  RobotFacts again(after.get());
  again.set({fact("lit", {"hall"}, true)}, nullptr);
  EXPECT_NE(again.follow(scope(), 60), "");
  again.beginSession("one", true);
  again.setModel(hall());
  EXPECT_EQ(stateOf(again), names({"(clean hall)", "(lit attic)"}));

  const auto later = file();
  RobotFacts last(later.get());
  last.follow(scope(), 60);
  EXPECT_EQ(believed(last), "(lit attic) (not (lit hall))");
}

TEST_F(KeptRobotFacts, areOfTheModelsThatTheNodeFollowsNow) {
  const auto before = file();
  RobotFacts facts(before.get());
  facts.follow(scope("first"), 60);
  facts.set({fact("lit", {"hall"})}, nullptr);
  facts.follow(scope("second"), 60);
  EXPECT_EQ(believed(facts), "(lit hall)") << "they hold as long as the node lives";

  const auto after = file();
  EXPECT_NE(RobotFacts(after.get()).follow(scope("second"), 60), "");
}

}  // namespace
}  // namespace goal_alignment::aligner
