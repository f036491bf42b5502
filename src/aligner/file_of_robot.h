// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>

namespace goal_alignment::aligner {

/// What a node keeps for itself in a folder that others share: "/robot1/goal_alignment" becomes
/// "robot1.goal_alignment.json". A name of ROS has no dot.
inline std::string fileOfRobot(const std::string& folder, std::string node) {
  node.erase(0, node.find_first_not_of('/'));
  std::replace(node.begin(), node.end(), '/', '.');
  return folder + "/" + node + ".json";
}

}  // namespace goal_alignment::aligner
