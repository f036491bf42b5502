// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/message_codec.h"

#include <gtest/gtest.h>
#include <move_base_msgs/MoveBaseGoal.h>

#include "goal_alignment/ExecutePlanResult.h"
#include "samples.h"

namespace goal_alignment::any_message::test {
namespace {

const ros::Time kNow(1000, 5);

class Codec : public testing::Test {
 protected:
  // As a server would read it.
  template <typename Message>
  Message decoded(const std::string& yaml) {
    Bytes bytes = encode(types_, types_.message(ros::message_traits::datatype<Message>()),
                         YAML::Load(yaml), arguments_, kNow);
    ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    Message message;
    ros::serialization::deserialize(in, message);
    EXPECT_EQ(in.getLength(), 0U);
    return message;
  }

  template <typename Message>
  static Bytes encoded(const Message& message) {
    Bytes bytes(ros::serialization::serializationLength(message));
    ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    ros::serialization::serialize(out, message);
    return bytes;
  }

  MessageTypes types_{installedDefinition};
  YAML::Node tables_ = YAML::Load(
      "{pose: {Kitchen: {position: {x: 1.5, y: -2}, orientation: {w: 1}}}, speed: {kitchen: 3}}");
  Arguments arguments_{step("go", {{"from", "hall"}, {"to", "kitchen"}}), tables_, "map.yaml"};
};

TEST_F(Codec, fillsAGoalOfMoveBase) {
  const auto goal = decoded<move_base_msgs::MoveBaseGoal>(
      "target_pose: {header: {frame_id: map}, pose: '{pose:to}'}");
  EXPECT_EQ(goal.target_pose.header.frame_id, "map");
  EXPECT_EQ(goal.target_pose.header.stamp, kNow) << "a header's stamp that is left out";
  EXPECT_EQ(goal.target_pose.pose.position.x, 1.5);
  EXPECT_EQ(goal.target_pose.pose.position.y, -2);
  EXPECT_EQ(goal.target_pose.pose.orientation.w, 1);
}

TEST_F(Codec, fillsTextsNumbersListsAndTimes) {
  const auto plan = decoded<Plan>(
      "{header: {stamp: 2.5}, session_id: '{action} {0} to {to} {{x}}', plan_id: '{speed:to}', "
      "cost: 1e3,"
      " optimal: true, steps: [{name: a, parameters: [{key: k, value: '{from}'}], duration: 0.5},"
      " {name: b}]}");
  EXPECT_EQ(plan.header.stamp, ros::Time(2.5));
  EXPECT_EQ(plan.session_id, "go hall to kitchen {x}");
  EXPECT_EQ(plan.plan_id, 3);
  EXPECT_EQ(plan.cost, 1000);
  EXPECT_TRUE(plan.optimal);
  ASSERT_EQ(plan.steps.size(), 2U);
  EXPECT_EQ(plan.steps[0].parameters[0].value, "hall");
  EXPECT_EQ(plan.steps[0].duration, 0.5F);
  EXPECT_EQ(plan.steps[1].name, "b");
}

TEST_F(Codec, leavesTheRestEmpty) {
  const auto plan = decoded<Plan>("");
  EXPECT_EQ(plan.plan_id, 0);
  EXPECT_TRUE(plan.steps.empty());
}

TEST_F(Codec, saysWhereAValueDoesNotFit) {
  const auto fault = [&](const std::string& yaml) {
    return faultOfCall([&] { decoded<Plan>(yaml); });
  };
  EXPECT_EQ(fault("plan_id: much"), "map.yaml:1:10: expected a int32, found 'much'");
  EXPECT_EQ(fault("plan_id: 3000000000"), "map.yaml:1:10: expected a int32, found '3000000000'");
  EXPECT_EQ(fault("\nsteps: 4"),
            "map.yaml:2:8: expected a list of goal_alignment/ActionDispatch, found '4'");
  EXPECT_EQ(fault("optimal: [1]"), "map.yaml:1:10: expected a bool, found a list");
  EXPECT_EQ(fault("session_id: '{where}'"),
            "map.yaml:1:13: the action go has no parameter 'where'");
  EXPECT_EQ(fault("session_id: '{speed:from}'"),
            "map.yaml:1:13: table 'speed' has no entry for 'hall'");
  EXPECT_EQ(fault("session_id: '{size:to}'"), "map.yaml:1:13: there is no table 'size'");
  EXPECT_EQ(fault("session_id: '{to'"), "map.yaml:1:13: '{' without '}' in '{to'");
  EXPECT_EQ(fault("header: {stamp: soon}"),
            "map.yaml:1:17: expected seconds or `now`, found 'soon'");
  EXPECT_EQ(fault("header: {stamp: 1e300}"),
            "map.yaml:1:17: expected seconds or `now`, found '1e300'");
}

TEST_F(Codec, checksFieldsBeforeThereAreArguments) {
  const auto fault = [&](const std::string& yaml) {
    return faultOfCall([&] {
      check(types_, types_.message("move_base_msgs/MoveBaseGoal"), YAML::Load(yaml), "map.yaml");
    });
  };
  EXPECT_EQ(fault("target_pose: {pose: '{pose:to}', header: {frame_id: '{to}'}}"), "");
  EXPECT_EQ(fault("target_pose: {pose: {position: {x: '{x:to}', y: 1}}}"), "");
  EXPECT_EQ(fault("target_pose:\n  poze: 1"),
            "map.yaml:2:3: geometry_msgs/PoseStamped has no field 'poze', but header, pose");
  EXPECT_EQ(fault("target_pose: kitchen"),
            "map.yaml:1:14: expected a map with the fields of geometry_msgs/PoseStamped, found "
            "'kitchen'");
}

TEST_F(Codec, findsAFieldBehindAllKindsOfOthers) {
  ExecutePlanResult result;
  result.outcome = ExecutePlanResult::STEP_FAILED;
  result.failed_step = -1;
  result.reason = "slipped";
  result.plan.steps.resize(3);
  result.plan.steps[1].parameters.resize(2);
  result.plan.guaranteed.resize(2);
  result.plan.guaranteed[1].args = {"a", "bc"};
  result.plan.cost = 2.5;
  result.replans = 7;
  const Bytes bytes = encoded(result);
  const MessageDefinition& type = types_.message("goal_alignment/ExecutePlanResult");
  const auto matching = [&](const std::string& path, const std::string& expected) {
    std::string found;
    const bool same = matches(types_, type, bytes, path, YAML::Load(expected), arguments_, found);
    return std::make_pair(same, found);
  };
  EXPECT_EQ(matching("outcome", "81"), std::make_pair(true, std::string("81")));
  EXPECT_EQ(matching("outcome", "1").first, false);
  EXPECT_EQ(matching("failed_step", "-1"), std::make_pair(true, std::string("-1")));
  EXPECT_EQ(matching("reason", "slipped"), std::make_pair(true, std::string("'slipped'")));
  EXPECT_EQ(matching("plan.cost", "2.5"), std::make_pair(true, std::string("2.5")));
  EXPECT_EQ(matching("plan.optimal", "true"), std::make_pair(false, std::string("false")));
  EXPECT_EQ(matching("replans", "7").first, true);
  const Bytes cut(bytes.begin(), bytes.end() - 20);
  std::string found;
  EXPECT_THROW(matches(types_, type, cut, "replans", YAML::Load("7"), arguments_, found),
               TypeError);
}

TEST_F(Codec, refusesPathsToNoValue) {
  const auto fault = [&](const std::string& path) {
    return faultOfCall(
        [&] { typeAt(types_, types_.message("goal_alignment/ExecutePlanResult"), path); });
  };
  EXPECT_EQ(fault("plan.header.frame_id"), "");
  EXPECT_EQ(fault("plan"), "goal_alignment/ExecutePlanResult: 'plan' is no single value");
  EXPECT_EQ(fault("plan.steps"), "goal_alignment/Plan: 'steps' is no single value");
  EXPECT_EQ(fault("reason.x"), "goal_alignment/ExecutePlanResult: 'reason.x' is no single value");
  EXPECT_NE(fault("error").find("has no field 'error', but outcome, failed_step"),
            std::string::npos);
}

}  // namespace
}  // namespace goal_alignment::any_message::test
