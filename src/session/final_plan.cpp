// SPDX-License-Identifier: BSD-3-Clause
#include "final_plan.h"

#include <algorithm>
#include <utility>

#include "extra_cost.h"
#include "fluents.h"
#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::session {

using achievability::CandidateSet;
using questions::Knowledge;

namespace {

struct Steps {
  std::vector<GroundName> names;
  bool optimal = false;
};

void throwIfCancelled(LimitReason limit) {
  if (limit == LimitReason::Cancelled) throw LimitReached(limit, "the final plan");
}

bool humanPlanAchieves(const std::vector<Literal>& goal, const Analysis& analysis) {
  const alignment::Problem& problem = analysis.problem();
  return analysis.robotAnalysis().human_plan_runs &&
         !validation::fault(problem.robot, problem.human_plan, goal,
                            analysis.budget().cancelOnly());
}

Steps optimalSteps(const CandidateSet& achieved, const task::Plan& first_plan, Analysis& analysis) {
  const task::Task& task = analysis.robot().task();
  const search::Result best = analysis.robot().optimalPlan(achieved, analysis.budget().limits());
  throwIfCancelled(best.limit);
  const bool solved = best.status == search::Status::Solved;
  return {task::names(task, solved ? best.plan : first_plan), solved};
}

Steps improvedSteps(const CandidateSet& achieved, const task::Plan& first_plan,
                    Analysis& analysis) {
  const search::Improved best =
      analysis.robot().improvedPlan(achieved, first_plan, analysis.budget().limits());
  throwIfCancelled(best.limit);
  return {task::names(analysis.robot().task(), best.plan), best.optimal};
}

Steps firstSteps(const CandidateSet& achieved, const task::Plan& first_plan,
                 const CandidateSet& not_wanted, Analysis& analysis) {
  const alignment::Problem& problem = analysis.problem();
  // The one to prefer where it gives all that is needed.
  if (humanPlanAchieves(specifiedAnd(problem, achieved), analysis))
    return {problem.human_plan, false};
  const task::Task& task = analysis.robot().task();
  if (not_wanted.any() && trueAtEnd(analysis, first_plan).intersects(not_wanted)) {
    // What is remembered does more than is wanted by now.
    return {task::names(task, improveBriefly(analysis, achieved, first_plan).plan), false};
  }
  return {task::names(task, first_plan), false};
}

Steps chooseSteps(const CandidateSet& achieved, const task::Plan& first_plan,
                  const CandidateSet& not_wanted, Analysis& analysis, PlanMode mode) {
  switch (mode) {
    case PlanMode::Optimal:
      return optimalSteps(achieved, first_plan, analysis);
    case PlanMode::Anytime:
      return improvedSteps(achieved, first_plan, analysis);
    case PlanMode::First:
      break;
  }
  return firstSteps(achieved, first_plan, not_wanted, analysis);
}

std::int64_t costOf(const std::vector<GroundName>& steps, const Analysis& analysis) {
  const validation::Execution execution =
      validation::execute(analysis.problem().robot, steps, analysis.budget().cancelOnly());
  return analysis.unitCosts() ? static_cast<std::int64_t>(steps.size()) : execution.cost();
}

}  // namespace

FinalPlan makeFinalPlan(const CandidateSet& achieved, const task::Plan& first_plan,
                        const Dialogue& dialogue, Analysis& analysis, PlanMode mode) {
  const alignment::Problem& problem = analysis.problem();
  const CandidateSet not_wanted = dialogue.with(Knowledge::NotWanted);
  const CandidateSet asked = dialogue.with(Knowledge::Wanted) | dialogue.with(Knowledge::Unsure);
  Steps steps = chooseSteps(achieved, first_plan, not_wanted, analysis, mode);
  FinalPlan plan;
  plan.steps = std::move(steps.names);
  plan.optimal = steps.optimal;
  plan.cost = costOf(plan.steps, analysis);
  plan.guaranteed = specifiedAnd(problem, asked);
  plan.kept_unasked = fluentsOf(problem, achieved - asked - not_wanted);
  plan.not_wanted = fluentsOf(problem, not_wanted - dialogue.assumed());
  plan.assumed_not_wanted = fluentsOf(problem, not_wanted & dialogue.assumed());
  if ((achieved - asked - analysis.robot().alwaysTrue()).any()) {
    const std::int64_t least = improveBriefly(analysis, asked, first_plan).cost;
    plan.extra_cost = std::max<std::int64_t>(0, plan.cost - least);
  }
  const auto fault = validation::fault(problem.robot, plan.steps, specifiedAnd(problem, achieved),
                                       analysis.budget().cancelOnly());
  if (fault) throw Exception("the plan found did not pass validation: " + *fault);
  return plan;
}

}  // namespace goal_alignment::session
