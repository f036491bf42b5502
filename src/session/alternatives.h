// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "analysis.h"
#include "dialogue.h"

namespace goal_alignment::session {

/// What there could be instead, where a dialogue ends with this code: everything not answered NO
/// but as little as will do to have the rest; after a proof that what was answered YES can't be
/// had, the same of that. The likeliest first. Nobody is left with nothing to choose as long as
/// some plan is known for what was asked for. Searches for seconds at most, or as long as the
/// limits let after a proof; empty where something goes wrong, for the outcome must not get lost.
std::vector<Alternative> alternativesAfter(OutcomeCode code, const Dialogue& dialogue,
                                           Analysis& analysis, const Options& options);

}  // namespace goal_alignment::session
