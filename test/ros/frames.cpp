// SPDX-License-Identifier: BSD-3-Clause
#include "frames.h"

namespace goal_alignment::test {
namespace {

geometry_msgs::TransformStamped inTheMap(const std::string& frame, double x, double y, double z) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.child_frame_id = frame;
  transform.transform.translation.x = x;
  transform.transform.translation.y = y;
  transform.transform.translation.z = z;
  transform.transform.rotation.w = 1;
  return transform;
}

}  // namespace

Frames::Frames() : thread_([this] { run(); }) {}

Frames::~Frames() {
  go_on_ = false;
  thread_.join();
}

void Frames::place(const std::string& frame, double x, double y, double z) {
  const std::lock_guard<std::mutex> lock(mutex_);
  frames_[frame] = inTheMap(frame, x, y, z);
}

void Frames::pullAway(const std::string& frame) {
  const std::lock_guard<std::mutex> lock(mutex_);
  frames_.erase(frame);
}

void Frames::tellOnce(const std::string& frame, double x, const ros::Time& stamp) {
  auto transform = inTheMap(frame, x, 0, 0);
  transform.header.stamp = stamp;
  const std::lock_guard<std::mutex> lock(mutex_);
  broadcaster_.sendTransform(transform);
}

void Frames::run() {
  while (go_on_) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      for (auto& [name, transform] : frames_) {
        transform.header.stamp = ros::Time::now();
        broadcaster_.sendTransform(transform);
      }
    }
    ros::WallDuration(0.03).sleep();
  }
}

}  // namespace goal_alignment::test
