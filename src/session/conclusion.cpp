// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "implementation.h"

/// Outcomes: the plan and what it promises.
namespace goal_alignment::session {

using achievability::CandidateSet;
using questions::Knowledge;

void Session::Implementation::conclude(const CandidateSet& achieved, const task::Plan& first_plan) {
  const auto began = Limits::Clock::now();
  Outcome outcome;
  outcome.code = OutcomeCode::Success;
  outcome.plan = finalPlan(achieved, first_plan);
  outcome.message =
      "I have a plan. It does what you asked and keeps everything you didn't rule out.";
  if (!outcome.plan.assumed_not_wanted.empty()) {
    outcome.message += " I don't promise this, since nobody was asked about it: " +
                       listed(outcome.plan.assumed_not_wanted) + ".";
  }
  const auto fault =
      validation::fault(problem_->robot, outcome.plan.steps, specifiedAnd(achieved), cancelOnly());
  if (fault) throw Exception("the plan found did not pass validation: " + *fault);
  finish(std::move(outcome));
  const std::chrono::duration<double> took = Limits::Clock::now() - began;
  statistics_.plan += took.count();
}

bool Session::Implementation::humanPlanAchieves(const std::vector<Literal>& goal) const {
  return robot_analysis_.human_plan_runs &&
         !validation::fault(problem_->robot, problem_->human_plan, goal, cancelOnly());
}

FinalPlan Session::Implementation::finalPlan(const CandidateSet& achieved,
                                             const task::Plan& first_plan) {
  FinalPlan plan;
  plan.steps = task::names(robot().task(), first_plan);
  const CandidateSet not_wanted = dialogue_.with(Knowledge::NotWanted);
  if (options_.plan == PlanMode::Optimal) {
    const search::Result best = robot().optimalPlan(achieved, limits());
    if (best.limit == LimitReason::Cancelled) throw LimitReached(best.limit, "the final plan");
    plan.optimal = best.status == search::Status::Solved;
    if (plan.optimal) plan.steps = task::names(robot().task(), best.plan);
  } else if (options_.plan == PlanMode::Anytime) {
    const search::Improved best = robot().improvedPlan(achieved, first_plan, limits());
    if (best.limit == LimitReason::Cancelled) throw LimitReached(best.limit, "the final plan");
    plan.optimal = best.optimal;
    plan.steps = task::names(robot().task(), best.plan);
  } else if (humanPlanAchieves(specifiedAnd(achieved))) {
    plan.steps = problem_->human_plan;  // the one to prefer where it gives all that is needed
  } else if (not_wanted.any() && trueAtEnd(first_plan).intersects(not_wanted)) {
    // What is remembered does more than is wanted by now.
    plan.steps = task::names(robot().task(), cheaply(achieved, first_plan).plan);
  }
  const validation::Execution execution =
      validation::execute(problem_->robot, plan.steps, cancelOnly());
  plan.cost = unit_costs_ ? static_cast<std::int64_t>(plan.steps.size()) : execution.cost();
  const CandidateSet asked = dialogue_.with(Knowledge::Wanted) | dialogue_.with(Knowledge::Unsure);
  plan.guaranteed = specifiedAnd(asked);
  plan.kept_unasked = fluents(achieved - asked - not_wanted);
  plan.not_wanted = fluents(not_wanted - dialogue_.assumed());
  plan.assumed_not_wanted = fluents(not_wanted & dialogue_.assumed());
  if (!(achieved - asked - robot().alwaysTrue()).none())
    plan.extra_cost = std::max<std::int64_t>(0, plan.cost - cheaply(asked, first_plan).cost);
  return plan;
}

std::vector<Literal> Session::Implementation::fluents(const CandidateSet& set) const {
  std::vector<Literal> result;
  for (const std::size_t f : achievability::members(set))
    result.push_back(dialogue_.fluents()[f]);
  return result;
}

std::vector<Literal> Session::Implementation::specifiedAnd(const CandidateSet& set) const {
  std::vector<Literal> result = problem_->specified;
  const std::vector<Literal> more = fluents(set);
  result.insert(result.end(), more.begin(), more.end());
  return result;
}

std::string Session::Implementation::listed(const std::vector<Literal>& literals) const {
  std::string text;
  for (const Literal& literal : literals) {
    const std::string atom = spelling(literal.atom);
    text += (text.empty() ? "" : ", ") + (literal.negated ? "(not " + atom + ")" : atom);
  }
  return text;
}

std::string Session::Implementation::askedFor() const {
  const std::string literals = listed(problem_->specified);
  return literals + (literals.empty() || problem_->condition.empty() ? "" : ", ") +
         problem_->condition;
}

}  // namespace goal_alignment::session
