// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "goal_alignment/common/quote.h"

namespace goal_alignment::pddl {

/// `; did you mean 'handempty'?` for the known name nearest to `wanted`, or nothing where none is
/// near. Case does not count. Meant for messages: O(known names · length²).
std::string suggestion(std::string_view wanted, const std::vector<std::string>& known);

}  // namespace goal_alignment::pddl
