// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/facts_follower.h"

#include <gtest/gtest.h>
#include <ros/time.h>
#include <tf2_ros/buffer.h>

#include <algorithm>
#include <string>
#include <vector>

#include "session_samples.h"

namespace goal_alignment::aligner {
namespace {

using session::OutcomeCode;
using session::State;

// (red b) where the thing is near, which nobody can tell without transforms.
constexpr const char* kRules = R"(
frames: {b: b_link}
regions:
  corner: {box: {xyz: [0, 0, 0], size: [1, 1]}}
rules:
  - fact: (red ?x)
    when: ?x in corner
    for: {x: b}
)";

Fluent fact(const std::string& name, const std::string& argument) {
  Fluent message;
  message.name = name;
  message.args = {argument};
  return message;
}

class FactsFollowerTest : public testing::Test {
 protected:
  FactsFollowerTest() {
    ros::Time::init();
    facts_.beginSession("s1", false);
    follower_.beginSession();
    follower_.beginGoal();
  }

  void loadModels() {
    samples::think(record_);
    follower_.onModelsLoaded();
  }

  SessionRecord record_ = samples::deskRecord();
  RobotFacts facts_;
  tf2_ros::Buffer frames_;
  TfStateBridge tf_{frames_};
  std::vector<std::string> lines_;
  FactsFollower follower_{record_, facts_, tf_,
                          [this](const std::string& line) { lines_.push_back(line); }};
};

TEST_F(FactsFollowerTest, doesNothingBeforeTheModelsAreLoaded) {
  follower_.update();
  EXPECT_FALSE(follower_.mustWait());
  EXPECT_EQ(record_.session->state(), State::Analysing);
}

TEST_F(FactsFollowerTest, passesReportedFactsToTheSession) {
  loadModels();
  follower_.update();
  EXPECT_TRUE(lines_.empty()) << "the first look is no news";
  EXPECT_EQ(follower_.nextLook(), FactsFollower::Clock::time_point::max()) << "no rules";
  ASSERT_TRUE(facts_.set({fact("red", "c")}, nullptr).accepted);
  follower_.update();
  const std::vector<GroundName> state = record_.session->robotState();
  EXPECT_NE(std::find(state.begin(), state.end(), GroundName::parse("(red c)")), state.end());
  EXPECT_EQ(lines_.size(), 1U);
  follower_.update();
  EXPECT_EQ(lines_.size(), 1U) << "nothing has changed";
}

TEST_F(FactsFollowerTest, waitsForTfAndThenGivesUp) {
  tf_.follow(spatial_facts::Rules::fromYaml(kRules, "rules.yaml"));
  record_.options.tf_timeout = 3600;
  loadModels();
  follower_.update();
  EXPECT_TRUE(follower_.mustWait());
  EXPECT_TRUE(follower_.isWithinTimeout());
  EXPECT_FALSE(follower_.haveChanged());
  EXPECT_NE(follower_.missingFacts().find("(red b)"), std::string::npos);
  record_.options.tf_timeout = 0;
  EXPECT_FALSE(follower_.isWithinTimeout());
  EXPECT_TRUE(follower_.haveChanged());
  follower_.update();
  EXPECT_EQ(record_.session->state(), State::Done);
  EXPECT_EQ(record_.session->outcome().code, OutcomeCode::StateUnknown);
  EXPECT_FALSE(follower_.mustWait());
}

TEST_F(FactsFollowerTest, rulesThatTheModelCantSatisfyEndTheSession) {
  std::string rules = kRules;
  rules.replace(rules.find("(red ?x)"), 8, "(blue ?x)");
  tf_.follow(spatial_facts::Rules::fromYaml(rules, "rules.yaml"));
  loadModels();
  EXPECT_EQ(record_.session->state(), State::Done);
  EXPECT_EQ(record_.session->outcome().code, OutcomeCode::InvalidModel);
}

}  // namespace
}  // namespace goal_alignment::aligner
