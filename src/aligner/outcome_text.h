// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/session/outcome.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::aligner {

/// What people are told of an outcome, in the language of the phrases; of what is wrong with the
/// models or the program the session's own message. `last` is how things stood then.
std::string spokenOutcome(const session::Outcome& outcome, const session::Snapshot& last,
                          const phrasing::Phrases& phrases,
                          const std::vector<GroundName>& human_plan);

}  // namespace goal_alignment::aligner
