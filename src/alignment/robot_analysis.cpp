// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/alignment/robot_analysis.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "goal_alignment/grounding/grounder.h"

namespace goal_alignment::alignment {

RobotAnalysis analyseRobot(const Problem& problem, bool unit_costs,
                           const achievability::SearchBudget& budget, const Limits& limits) {
  std::vector<Literal> fluents;
  for (const Candidate& candidate : problem.candidates)
    fluents.push_back(candidate.fluent);
  grounding::GroundTask task =
      grounding::ground(problem.robot, literals(problem), {unit_costs}, limits);

  RobotAnalysis side;
  side.achievability = std::make_unique<achievability::Achievability>(
      std::move(task), problem.specified, fluents, budget, limits);
  const validation::Execution execution =
      validation::execute(problem.robot, problem.human_plan, limits);
  const auto steps_run = static_cast<std::ptrdiff_t>(execution.stepsRun());
  side.achievability->recordExecution(
      {problem.human_plan.begin(), problem.human_plan.begin() + steps_run}, limits);
  side.human_plan_runs = !execution.violation;
  side.human_plan_violation = execution.violation;
  return side;
}

}  // namespace goal_alignment::alignment
