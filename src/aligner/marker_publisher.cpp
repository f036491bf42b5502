// SPDX-License-Identifier: BSD-3-Clause
#include "marker_publisher.h"

#include <tf2/exceptions.h>

#include <cmath>
#include <utility>

#include "goal_alignment/ros_common/names.h"
#include "node_options.h"

namespace goal_alignment::aligner {
namespace {

constexpr double kPeriod = 0.5;       // seconds
constexpr double kCoarseness = 0.02;  // metres: an arrow need not follow a trembling frame

double coarse(double metres) {
  return std::round(metres / kCoarseness) * kCoarseness;
}

}  // namespace

MarkerPublisher::MarkerPublisher(ros::NodeHandle private_node, const Announcer& announcer,
                                 const tf2_ros::Buffer& frames)
    : private_node_(std::move(private_node)),
      announcer_(announcer),
      frames_(frames),
      markers_(private_node_.advertise<visualization_msgs::MarkerArray>(
          ros_common::kMarkersTopic, ros_common::kStateQueueSize, true)),
      timer_(private_node_.createWallTimer(ros::WallDuration(kPeriod),
                                           [this](const ros::WallTimerEvent&) { look(); })) {}

void MarkerPublisher::look() {
  const AlignmentState state = announcer_.state();
  if (state.session_id != session_) readOptions(state.session_id);
  visualization_msgs::MarkerArray markers =
      wanted_ ? markersOf(state, announcer_.plan(), whereabouts())
              : markersOf(AlignmentState{}, Plan{}, whereabouts());
  if (markers.markers == shown_.markers) return;
  shown_ = std::move(markers);
  markers_.publish(shown_);
}

// As for every goal; one with a faulty parameter is refused, and that says why.
void MarkerPublisher::readOptions(const std::string& session_id) {
  session_ = session_id;
  try {
    const NodeOptions options = NodeOptions::read(private_node_);
    wanted_ = options.markers;
    frame_of_ = options.marker_frames;
  } catch (const ros_common::ParameterError&) {
    wanted_ = true;
    frame_of_.clear();
  }
}

Whereabouts MarkerPublisher::whereabouts() const {
  Whereabouts result;
  result.frame_of = [this](const std::string& object) {
    const auto mapped = frame_of_.find(object);
    const std::string& frame = mapped == frame_of_.end() ? object : mapped->second;
    return frames_._frameExists(frame) ? frame : std::string();
  };
  result.origin = [this](const std::string& frame,
                         const std::string& seen_from) -> std::optional<geometry_msgs::Point> {
    try {
      const auto& offset =
          frames_.lookupTransform(seen_from, frame, ros::Time(0)).transform.translation;
      geometry_msgs::Point point;
      point.x = coarse(offset.x);
      point.y = coarse(offset.y);
      point.z = coarse(offset.z);
      return point;
    } catch (const tf2::TransformException&) {
      return std::nullopt;
    }
  };
  return result;
}

}  // namespace goal_alignment::aligner
