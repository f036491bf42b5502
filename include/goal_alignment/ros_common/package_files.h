// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace goal_alignment::ros_common {

/// An absolute path as it is; a relative one below this package's folder, so that
/// `config/domains/tea/robot_domain.pddl` names the same file in source and install space.
std::string resolveFile(const std::string& file);

/// $ROS_HOME, or ~/.ros where that is not set.
std::string rosHome();

}  // namespace goal_alignment::ros_common
