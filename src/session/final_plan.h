// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "analysis.h"
#include "dialogue.h"

namespace goal_alignment::session {

/// The plan that is handed out for these candidates and what it promises; `first_plan` has all of
/// them. Better ones are looked for as `mode` has it. It has passed validation. Throws LimitReached
/// on a cancel, and Exception where it does not pass.
FinalPlan makeFinalPlan(const achievability::CandidateSet& achieved, const task::Plan& first_plan,
                        const Dialogue& dialogue, Analysis& analysis, PlanMode mode);

}  // namespace goal_alignment::session
