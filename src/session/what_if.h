// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "analysis.h"
#include "dialogue.h"

/// What would follow from answers that nobody has given.
namespace goal_alignment::session {

/// What would be known of the candidates. Throws std::invalid_argument naming a fluent that is no
/// candidate, or is in both lists.
std::vector<questions::Knowledge> suppose(const Dialogue& dialogue,
                                          const std::vector<Literal>& wanted,
                                          const std::vector<Literal>& not_wanted);

/// The robot must have been analysed. Thinks for at most so many seconds.
Consequence consequenceOf(const std::vector<questions::Knowledge>& then, Analysis& analysis,
                          const Options& options, double seconds);

}  // namespace goal_alignment::session
