// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2/LinearMath/Transform.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace goal_alignment::execution {

/// `[x, y, yaw]`, `[x, y, z, yaw]` in metres and radians, or a map with the fields of
/// geometry_msgs/Pose; nothing is the identity. Throws YamlError.
tf2::Transform poseOf(const YAML::Node& node, const std::string& source);

/// Frames of a simulated world, and how they move. Thread-safe.
class SimulatedFrames {
 public:
  /// One frame's way through a step.
  struct Motion {
    std::string frame;
    std::optional<tf2::Transform> to;   ///< in the parent it has at the end
    std::optional<std::string> parent;  ///< that it gets at the end
  };

  /// A frame that is there already stays where it is.
  void add(const std::string& frame, const std::string& parent, const tf2::Transform& pose);

  /// A step begins. Throws std::invalid_argument for a frame that is not on the stage, one without
  /// a common root with its new parent, and one that would hang from itself.
  void begin(const std::vector<Motion>& motions);
  /// The frames that get no other parent are so far on their straight way, 0 … 1.
  void glide(double fraction);
  /// The step has ended well: everything is where it was to be.
  void finish();

  std::vector<geometry_msgs::TransformStamped> transforms(const ros::Time& stamp) const;

 private:
  struct Frame {
    std::string parent;
    tf2::Transform pose;  // in the parent
  };
  struct UnderWay {
    Motion motion;
    tf2::Transform from;
  };

  // All below need mutex_.
  tf2::Transform inRoot(const std::string& frame, std::string& root) const;
  void checkMotion(const Motion& motion) const;
  void refuseCircle(const std::vector<Motion>& motions) const;
  void attach(const Motion& motion);

  mutable std::mutex mutex_;
  std::map<std::string, Frame> frames_;
  std::vector<UnderWay> under_way_;
};

}  // namespace goal_alignment::execution
