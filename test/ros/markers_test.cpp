// SPDX-License-Identifier: BSD-3-Clause
// What ~markers shows while frames come up.
#include <geometry_msgs/TransformStamped.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <visualization_msgs/MarkerArray.h>

#include "scenario.h"

namespace goal_alignment::test {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

class Markers : public Scenario {
 protected:
  Markers() : markers_(node_, "/goal_alignment/markers") {}

  void TearDown() override {
    node_.deleteParam("/goal_alignment/marker_frames");
    node_.deleteParam("/goal_alignment/markers");
    Scenario::TearDown();
  }

  void place(const std::string& frame) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.header.stamp = ros::Time::now();
    transform.child_frame_id = frame;
    transform.transform.rotation.w = 1;
    broadcaster_.sendTransform(transform);
  }

  // A text at the frame appears.
  bool showsTextAt(const std::string& frame) {
    return markers_
        .waitFor([&](const MarkerArray& shown) {
          return std::any_of(shown.markers.begin(), shown.markers.end(), [&](const Marker& marker) {
            return marker.type == Marker::TEXT_VIEW_FACING && marker.header.frame_id == frame &&
                   !marker.text.empty();
          });
        })
        .has_value();
  }

  tf2_ros::StaticTransformBroadcaster broadcaster_;
  Topic<MarkerArray> markers_;
};

TEST_F(Markers, standAtTheFramesOfWhatTheyMention) {
  sendAndAwaitQuestion(sweepHall());
  place("hall");
  EXPECT_TRUE(showsTextAt("hall")) << "a frame that comes up later is found";
  EXPECT_TRUE(answer(Answer::Request::NO).accepted);
  awaitResult();
}

TEST_F(Markers, aFrameMayHaveAnotherNameThanItsObject) {
  node_.setParam("/goal_alignment/marker_frames",
                 std::map<std::string, std::string>{{"hall", "hall_floor"}});
  place("hall_floor");
  sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(showsTextAt("hall_floor"));
  EXPECT_TRUE(answer(Answer::Request::NO).accepted);
  awaitResult();
}

TEST_F(Markers, mayBeTurnedOff) {
  place("hall");
  sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(showsTextAt("hall"));
  EXPECT_TRUE(answer(Answer::Request::NO).accepted);
  awaitResult();
  node_.setParam("/goal_alignment/markers", false);
  sendAndAwaitQuestion(sweepHall());
  EXPECT_TRUE(eventually([this] { return markers_.last()->markers.size() == 1; }));
  EXPECT_EQ(markers_.last()->markers.at(0).action, Marker::DELETEALL);
  EXPECT_TRUE(answer(Answer::Request::NO).accepted);
  awaitResult();
}

}  // namespace
}  // namespace goal_alignment::test
