// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dnf_bounds.h"

namespace goal_alignment::questions {

/// P(the dialogue ends with NO) as if the sets were independent of each other: a lower bound
/// (Harris, 1960).
double chanceOfNo(const MonotoneDnf& dnf, const Chances& p);

/// The candidates whose answer minimises the expected entropy of how the dialogue ends, YES or NO;
/// none where that is certain already. One step of look-ahead: O(candidates · sets · size), in the
/// worst case times the sets. A good guide where NO is likely: it asks first what many unlikely
/// sets share, which the P/E of one set does not see. Where YES is all but certain every answer
/// leaves the same entropy.
CandidateMask mostInformative(const MonotoneDnf& dnf, const Chances& p);

}  // namespace goal_alignment::questions
