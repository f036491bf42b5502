// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/simulated_frames.h"

#include <gtest/gtest.h>

#include <cmath>

#include "samples.h"

namespace goal_alignment::execution::test {
namespace {

class Stage : public testing::Test {
 protected:
  Stage() {
    stage_.add("base", "map", pose("[0, 0, 0]"));
    stage_.add("gripper", "base", pose("[1, 0, 1, 0]"));
    stage_.add("cup", "map", pose("[3, 0, 0]"));
  }

  static tf2::Transform pose(const std::string& yaml) { return poseOf(YAML::Load(yaml), "p"); }

  geometry_msgs::TransformStamped frame(const std::string& name) const {
    for (const auto& transform : stage_.transforms(ros::Time(1))) {
      if (transform.child_frame_id == name) return transform;
    }
    return {};
  }

  std::string refusal(const SimulatedFrames::Motion& motion) {
    return faultOfCall([&] { stage_.begin({motion}); });
  }

  SimulatedFrames stage_;
};

TEST_F(Stage, glidesAlongAStraightLine) {
  stage_.begin({{"base", pose("[2, 4, 1]"), {}}});
  stage_.glide(0.25);
  EXPECT_NEAR(frame("base").transform.translation.x, 0.5, 1e-9);
  EXPECT_NEAR(frame("base").transform.translation.y, 1, 1e-9);
  EXPECT_NEAR(2 * std::asin(frame("base").transform.rotation.z), 0.25, 1e-9);
  stage_.finish();
  EXPECT_NEAR(frame("base").transform.translation.x, 2, 1e-9);
  EXPECT_EQ(frame("base").header.frame_id, "map");
}

TEST_F(Stage, attachesAThingWhereItIs) {
  stage_.begin({{"base", pose("[2, 0, 0]"), {}}, {"cup", {}, std::string("gripper")}});
  stage_.glide(1);
  stage_.finish();
  EXPECT_EQ(frame("cup").header.frame_id, "gripper");
  EXPECT_NEAR(frame("cup").transform.translation.x, 0, 1e-9) << "3 from 2 + 1";
  EXPECT_NEAR(frame("cup").transform.translation.z, -1, 1e-9);
}

TEST_F(Stage, attachesAThingAtAPose) {
  stage_.begin({{"cup", pose("[0, 0, 0.1, 0]"), std::string("gripper")}});
  stage_.glide(0.5);
  EXPECT_EQ(frame("cup").header.frame_id, "map") << "not before the end";
  stage_.finish();
  EXPECT_NEAR(frame("cup").transform.translation.z, 0.1, 1e-9);
}

TEST_F(Stage, leavesWhatIsThereWhereItIs) {
  stage_.add("base", "odom", pose("[9, 9, 9]"));
  EXPECT_EQ(frame("base").header.frame_id, "map");
}

TEST_F(Stage, refusesWhatCantBe) {
  EXPECT_EQ(refusal({"arm", pose("[0, 0, 0]"), {}}), "no simulated frame is called arm");
  EXPECT_EQ(refusal({"cup", {}, std::string("moon")}),
            "the frames cup and moon have no common root");
  EXPECT_EQ(refusal({"base", {}, std::string("gripper")}), "the frame base would hang from itself");
}

TEST_F(Stage, refusesMotionsThatTogetherMakeACircle) {
  stage_.add("tray", "map", pose("[1, 1, 0]"));
  EXPECT_EQ(faultOfCall([&] {
              stage_.begin({{"cup", {}, std::string("tray")}, {"tray", {}, std::string("cup")}});
            }),
            "the frame cup would hang from itself");
  stage_.finish();
  EXPECT_EQ(frame("cup").header.frame_id, "map") << "nothing has moved";
  stage_.begin({{"cup", {}, std::string("tray")}, {"tray", {}, std::string("gripper")}});
  stage_.finish();
  EXPECT_EQ(frame("cup").header.frame_id, "tray");
  EXPECT_EQ(frame("tray").header.frame_id, "gripper");
}

TEST(Pose, hasThreeForms) {
  const auto read = [](const std::string& yaml) { return poseOf(YAML::Load(yaml), "p"); };
  EXPECT_EQ(read("").getOrigin(), tf2::Vector3(0, 0, 0));
  EXPECT_EQ(read("[1, 2, 0]").getOrigin(), tf2::Vector3(1, 2, 0));
  EXPECT_EQ(read("[1, 2, 3, 0]").getOrigin(), tf2::Vector3(1, 2, 3));
  EXPECT_EQ(read("{position: {y: 4}}").getOrigin(), tf2::Vector3(0, 4, 0));
  EXPECT_NEAR(read("{orientation: {z: 2, w: 2}}").getRotation().w(), std::sqrt(0.5), 1e-9);
  EXPECT_EQ(faultOfCall([&] { read("{orientation: {z: 0}}"); }),
            "p:1:1: the orientation is no rotation: its length is 0");
  EXPECT_EQ(faultOfCall([&] { read("[1, x, 3]"); }), "p:1:5: expected a number, found 'x'");
}

}  // namespace
}  // namespace goal_alignment::execution::test
