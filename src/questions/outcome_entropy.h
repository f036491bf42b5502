// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dnf_bounds.h"

namespace goal_alignment::questions {

/// P(the dialogue ends with NO), as if the sets were independent of each other: what Harris (1960)
/// has for the least it can be.
double chanceOfNo(const MonotoneDnf& dnf, const Chances& p);

/// The candidates whose answer is expected to leave least doubt whether the dialogue ends with YES
/// or NO; none where there is no doubt now. One step of look-ahead: O(candidates · sets · size),
/// and sets² at worst. Guides well where NO is likely: what many unlikely sets share goes first,
/// which one set's P/E does not see. Where YES is all but certain every answer leaves the same
/// doubt.
CandidateMask leavingLeastDoubt(const MonotoneDnf& dnf, const Chances& p);

}  // namespace goal_alignment::questions
