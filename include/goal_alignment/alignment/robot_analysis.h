// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/validation/execution.h"

namespace goal_alignment::alignment {

/// The problem seen from the robot: what it can achieve of S^H, and how far π^H carries it.
struct RobotAnalysis {
  std::unique_ptr<achievability::Achievability> achievability;
  bool human_plan_runs = false;                               ///< to its end
  std::optional<validation::Violation> human_plan_violation;  ///< of the first step that doesn't
};

/// Grounds the robot's model, finds the conflicts of stages 0 to 2. Throws LimitReached,
/// pddl::SemanticError (an action without a cost) and pddl::UnsupportedError (a goal with a
/// condition; conditions with too many alternatives).
RobotAnalysis analyseRobot(const Problem& problem, bool unit_costs,
                           const achievability::SearchBudget& budget, const Limits& limits);

}  // namespace goal_alignment::alignment
