// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/Plan.h"
#include "goal_alignment/any_message/message_definition.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/execution/step_mapping.h"

/// What can be said of a plan before any of its steps begins.
namespace goal_alignment::execution {

/// Why a plan can't be run as it stands; empty: it can.
std::string faultOf(const Plan& plan);

/// Why the steps of the plan can't be carried out with this mapping; empty: they can.
std::string mappingFault(const Plan& plan, const StepMapping& mapping,
                         any_message::MessageTypes& types);

/// What the robot knows when the step has failed. Throws YamlError.
std::vector<Literal> failureFacts(const ActionDispatch& step, const StepRule& rule,
                                  const StepMapping& mapping);

}  // namespace goal_alignment::execution
