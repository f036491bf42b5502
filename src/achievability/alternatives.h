// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/common/limits.h"

namespace goal_alignment::achievability {

/// Does what Achievability::alternatives() says, by the checks and conflicts of `robot`.
std::vector<CandidateSet> findAlternatives(Achievability& robot, const CandidateSet& wanted,
                                           const std::vector<double>& belief,
                                           std::size_t max_alternatives, const Limits& limits);

}  // namespace goal_alignment::achievability
