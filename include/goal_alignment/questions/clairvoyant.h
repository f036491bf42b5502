// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"

namespace goal_alignment::questions {

/// How many answers somebody would need who knew what is wanted and had to prove the outcome: the
/// size of the smallest conflict within `wanted`; where there is none, of the smallest set of
/// candidates not wanted that hits every conflict. No policy asks fewer questions. The latter is
/// NP-hard (Karp, 1972); branch and bound does 40 candidates in 200 conflicts within milliseconds.
std::size_t clairvoyantMinimum(const std::vector<achievability::Conflict>& conflicts,
                               const achievability::CandidateSet& wanted);

}  // namespace goal_alignment::questions
