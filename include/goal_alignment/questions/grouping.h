// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// One question, "which of these matter to you?", about at most so many candidates; nothing where
/// the policy has nothing left to ask. Each comes with the conflict that makes its answer matter.
std::vector<Choice> nextGroup(Policy& policy, const Situation& situation, std::size_t most);

}  // namespace goal_alignment::questions
