// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace goal_alignment {

/// The folder of this source tree. Told by the build: `__FILE__` may be relative to anything.
inline std::filesystem::path sourceRoot() {
  return GOAL_ALIGNMENT_SOURCE_ROOT;
}

}  // namespace goal_alignment
