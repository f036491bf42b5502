// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/execution/step_mapping.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::execution {

/// Where the mapping does not fit the robot's model: actions that one of both lacks, parameters
/// that an action does not have, tables without some of the objects that they are asked for,
/// failure facts that can't be. Each as `file:line:column: …` and with the nearest name; a plan
/// that needs such a thing is refused.
std::vector<std::string> misfits(const StepMapping& mapping, const pddl::Model& robot);

}  // namespace goal_alignment::execution
