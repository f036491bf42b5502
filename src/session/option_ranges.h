// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/session/options.h"

namespace goal_alignment::session {

/// Throws std::invalid_argument that says which option is out of its range.
void requireInRange(const Options& options);

}  // namespace goal_alignment::session
