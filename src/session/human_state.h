// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::session {

/// The human's problem no longer says all that is so for them: their model's initial state becomes
/// what it is by now. Left out is what their model can't have, and of what the robot reported also
/// those predicates that its own model has not, or with another number of arguments, and those that
/// the human's plan contradicts: where a step needs of a predicate what is so in their problem file
/// and no longer in the world, that is what they hold true. Throws LimitReached.
/// O(facts + human.init + executions of the plan, at most one for each predicate reported).
void applyHumanFacts(const std::vector<HumanFact>& facts, const std::vector<GroundName>& human_plan,
                     const pddl::Model& robot, pddl::Model& human, const Limits& limits);

}  // namespace goal_alignment::session
