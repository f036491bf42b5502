// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2_ros/transform_broadcaster.h>

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "scenario.h"

namespace goal_alignment::test {

/// Tells tf again and again where frames are in the map, until this object is gone.
class Frames {
 public:
  Frames();
  ~Frames();
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  /// From now on it is there.
  void place(const std::string& frame, double x, double y = 0, double z = 0);
  /// From now on nobody hears of it.
  void pullAway(const std::string& frame);
  /// Once, with this stamp.
  void tellOnce(const std::string& frame, double x, const ros::Time& stamp);

 private:
  void run();

  tf2_ros::TransformBroadcaster broadcaster_;
  std::mutex mutex_;  // guards the frames and the broadcaster
  std::map<std::string, geometry_msgs::TransformStamped> frames_;
  std::atomic<bool> go_on_{true};
  std::thread thread_;
};

}  // namespace goal_alignment::test
