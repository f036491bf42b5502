// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace goal_alignment::ros_common {

/// The time for message stamps: ROS time, or wall time while a simulated clock has not begun,
/// since actionlib and onlookers take a zero stamp for none.
inline ros::Time stampNow() {
  const ros::Time now = ros::Time::now();
  if (!now.isZero()) return now;
  const ros::WallTime wall = ros::WallTime::now();
  return {wall.sec, wall.nsec};
}

}  // namespace goal_alignment::ros_common
