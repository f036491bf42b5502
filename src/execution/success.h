// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "goal_alignment/execution/steps.h"

namespace goal_alignment::execution {

/// Whether the result or response of server `name` is what the rule takes for a success.
StepEnd checkSuccess(const StepTry& attempt, const any_message::MessageDefinition& definition,
                     const std::optional<any_message::Bytes>& message, const std::string& name);

}  // namespace goal_alignment::execution
