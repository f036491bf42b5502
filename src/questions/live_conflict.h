// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// The live conflict with the candidate in it that has the fewest open candidates, proven ones
/// first: the shortest reason for asking.
std::optional<std::size_t> smallestLiveConflict(const Situation& situation, std::size_t candidate);

}  // namespace goal_alignment::questions
