// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace goal_alignment::any_message {

/// The MD5 of the text (RFC 1321) in hexadecimal digits: by it ROS tells message types apart.
std::string md5Of(const std::string& text);

}  // namespace goal_alignment::any_message
