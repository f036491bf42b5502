// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace goal_alignment::ros_common {

/// To be called before ros::init(): ROS's log otherwise has `?` for every letter beyond ASCII where
/// the environment has no locale of UTF-8, as in most containers and under systemd. Numbers are
/// written as before.
void logInUtf8();

}  // namespace goal_alignment::ros_common
