// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "decision.h"
#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/session/outcome.h"

/// Decisions as outcomes.
namespace goal_alignment::session {

Outcome outcomeOf(FinalPlan plan, const alignment::Problem& problem);
Outcome outcomeOf(const GoalUnsolvable& decision, const alignment::Problem& problem);
/// With code ExpectationUnachievable. `conflict`: the smallest that is known within that of NoPlan.
Outcome expectationUnachievable(const achievability::Conflict& conflict,
                                std::vector<Alternative> alternatives,
                                const alignment::Problem& problem);
Outcome outcomeOf(const Blocked& decision, const alignment::Problem& problem);
Outcome outcomeOf(const Exhausted& decision, const alignment::Problem& problem);

}  // namespace goal_alignment::session
