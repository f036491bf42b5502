// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace goal_alignment::ros_common {

/// The file has this text from now on, also after a power cut: a reader finds the old text or the
/// new one, never half of one. Its folder is made where there is none. Throws std::exception.
void replaceFile(const std::string& path, const std::string& text);

/// Renames a file that can't be read to `….damaged` and says what became of it.
std::string setAside(const std::string& path);

/// Where setAside() puts it.
std::string asideOf(const std::string& path);

}  // namespace goal_alignment::ros_common
