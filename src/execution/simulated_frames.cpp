// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/simulated_frames.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "goal_alignment/any_message/arguments.h"

namespace goal_alignment::execution {
namespace {

constexpr const char* kPoseForms =
    "a pose: [x, y, yaw], [x, y, z, yaw] or a map of position and orientation";
constexpr double kShortestQuaternion = 1e-6;

[[noreturn]] void refuse(const YAML::Node& node, const std::string& source) {
  YamlReader(source).failAt(
      node.Mark(), fmt::format("expected {}, found {}", kPoseForms, YamlReader::describe(node)));
}

double coordinate(const YAML::Node& node, const std::string& source) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    YamlReader(source).failAt(
        node.Mark(), fmt::format("expected a number, found {}", YamlReader::describe(node)));
  }
  return value;
}

double field(const YAML::Node& map, const char* key, double otherwise, const std::string& source) {
  if (!map.IsDefined()) return otherwise;
  if (!map.IsMap()) refuse(map, source);
  const YAML::Node& fields = map;
  const YAML::Node value = fields[key];
  return value.IsDefined() ? coordinate(value, source) : otherwise;
}

tf2::Quaternion yawed(double yaw) {
  tf2::Quaternion rotation;
  rotation.setRPY(0, 0, yaw);
  return rotation;
}

}  // namespace

tf2::Transform poseOf(const YAML::Node& node, const std::string& source) {
  if (!node.IsDefined() || node.IsNull()) return tf2::Transform::getIdentity();
  if (node.IsSequence() && (node.size() == 3 || node.size() == 4)) {
    const auto at = [&](std::size_t i) { return coordinate(node[i], source); };
    const bool has_height = node.size() == 4;
    return tf2::Transform(yawed(at(node.size() - 1)),
                          tf2::Vector3(at(0), at(1), has_height ? at(2) : 0));
  }
  if (!node.IsMap()) refuse(node, source);
  for (const auto& entry : node) {
    const std::string key = entry.first.Scalar();
    if (key != "position" && key != "orientation") refuse(node, source);
  }
  const YAML::Node p = node["position"];
  const YAML::Node q = node["orientation"];
  const auto part = [&](const YAML::Node& map, const char* key) {
    return field(map, key, 0, source);
  };
  tf2::Quaternion rotation(part(q, "x"), part(q, "y"), part(q, "z"),
                           field(q, "w", q.IsDefined() ? 0 : 1, source));
  if (rotation.length() < kShortestQuaternion) {
    YamlReader(source).failAt(node.Mark(), "the orientation is no rotation: its length is 0");
  }
  return tf2::Transform(rotation.normalized(),
                        tf2::Vector3(part(p, "x"), part(p, "y"), part(p, "z")));
}

void SimulatedFrames::add(const std::string& frame, const std::string& parent,
                          const tf2::Transform& pose) {
  const std::lock_guard<std::mutex> lock(mutex_);
  frames_.emplace(frame, Frame{parent, pose});
}

tf2::Transform SimulatedFrames::inRoot(const std::string& frame, std::string& root) const {
  tf2::Transform pose = tf2::Transform::getIdentity();
  root = frame;
  // No chain is longer than there are frames, so that a circle ends as well.
  for (std::size_t i = 0; i <= frames_.size(); ++i) {
    const auto found = frames_.find(root);
    if (found == frames_.end()) return pose;
    pose = found->second.pose * pose;
    root = found->second.parent;
  }
  throw std::invalid_argument(fmt::format("the frame {} hangs from itself", frame));
}

void SimulatedFrames::checkMotion(const Motion& motion) const {
  if (frames_.count(motion.frame) == 0) {
    throw std::invalid_argument(fmt::format("no simulated frame is called {}", motion.frame));
  }
  if (!motion.parent) return;
  std::string root;
  std::string parents_root;
  inRoot(motion.frame, root);
  inRoot(*motion.parent, parents_root);
  if (root != parents_root) {
    throw std::invalid_argument(
        fmt::format("the frames {} and {} have no common root", motion.frame, *motion.parent));
  }
  for (auto up = frames_.find(*motion.parent); up != frames_.end();
       up = frames_.find(up->second.parent)) {
    if (up->first != motion.frame) continue;
    throw std::invalid_argument(fmt::format("the frame {} would hang from itself", motion.frame));
  }
}

void SimulatedFrames::begin(const std::vector<Motion>& motions) {
  const std::lock_guard<std::mutex> lock(mutex_);
  under_way_.clear();
  for (const Motion& motion : motions)
    checkMotion(motion);
  refuseCircle(motions);
  for (const Motion& motion : motions)
    under_way_.push_back({motion, frames_.at(motion.frame).pose});
}

// Two motions that are good one by one may each put its frame onto the other's.
void SimulatedFrames::refuseCircle(const std::vector<Motion>& motions) const {
  std::map<std::string, std::string> parents;
  for (const auto& [name, frame] : frames_)
    parents[name] = frame.parent;
  for (const Motion& motion : motions) {
    if (motion.parent) parents[motion.frame] = *motion.parent;
  }
  for (const Motion& motion : motions) {
    auto up = parents.find(motion.frame);
    for (std::size_t i = 0; up != parents.end(); ++i, up = parents.find(up->second)) {
      if (i <= parents.size()) continue;
      throw std::invalid_argument(fmt::format("the frame {} would hang from itself", motion.frame));
    }
  }
}

void SimulatedFrames::glide(double fraction) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const UnderWay& each : under_way_) {
    if (each.motion.parent || !each.motion.to) continue;
    tf2::Transform& pose = frames_.at(each.motion.frame).pose;
    pose.setOrigin(each.from.getOrigin().lerp(each.motion.to->getOrigin(), fraction));
    const tf2::Quaternion from = each.from.getRotation();
    pose.setRotation(from.slerp(each.motion.to->getRotation(), fraction).normalized());
  }
}

void SimulatedFrames::attach(const Motion& motion) {
  Frame& frame = frames_.at(motion.frame);
  if (motion.to) {
    frame.pose = *motion.to;
  } else {
    std::string root;
    frame.pose = inRoot(*motion.parent, root).inverse() * inRoot(motion.frame, root);
  }
  if (motion.parent) frame.parent = *motion.parent;
}

void SimulatedFrames::finish() {
  const std::lock_guard<std::mutex> lock(mutex_);
  // Those that stay with their parent first: another may be put onto where one has come to.
  for (const bool with_parent : {false, true}) {
    for (const UnderWay& each : under_way_) {
      if (each.motion.parent.has_value() == with_parent) attach(each.motion);
    }
  }
  under_way_.clear();
}

std::vector<geometry_msgs::TransformStamped> SimulatedFrames::transforms(
    const ros::Time& stamp) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<geometry_msgs::TransformStamped> messages;
  for (const auto& [name, frame] : frames_) {
    geometry_msgs::TransformStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = frame.parent;
    message.child_frame_id = name;
    const tf2::Vector3& origin = frame.pose.getOrigin();
    message.transform.translation.x = origin.x();
    message.transform.translation.y = origin.y();
    message.transform.translation.z = origin.z();
    const tf2::Quaternion rotation = frame.pose.getRotation();
    message.transform.rotation.x = rotation.x();
    message.transform.rotation.y = rotation.y();
    message.transform.rotation.z = rotation.z();
    message.transform.rotation.w = rotation.w();
    messages.push_back(message);
  }
  return messages;
}

}  // namespace goal_alignment::execution
