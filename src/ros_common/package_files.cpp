// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/package_files.h"

#include <ros/package.h>

#include <cstdlib>

#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::ros_common {

std::string resolveFile(const std::string& file) {
  if (file.empty() || file.front() == '/') return file;
  // Crawls the package path at the first call; roslib remembers it.
  static const std::string package = ros::package::getPath(kPackage);
  return package + "/" + file;
}

std::string rosHome() {
  const char* ros_home = std::getenv("ROS_HOME");
  if (ros_home != nullptr && *ros_home != '\0') return ros_home;
  const char* home = std::getenv("HOME");
  return std::string(home != nullptr ? home : "") + "/.ros";
}

}  // namespace goal_alignment::ros_common
