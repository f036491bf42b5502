// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "implementation.h"

/// The heart of a session: from what is known to a question or an outcome. A dialogue may end
/// exactly when the fluents answered NO hit every conflict (then everything else has a plan), or a
/// proven conflict lies within the fluents answered YES.
namespace goal_alignment::session {

using achievability::CandidateSet;
using achievability::Check;
using achievability::Conflict;
using achievability::Verdict;
using questions::Knowledge;

namespace {

/// More alternatives than a person reads.
constexpr std::size_t kMostAlternatives = 10;

}  // namespace

questions::Situation Session::Implementation::situation() const {
  return {dialogue_.knowledge(), beliefs_, robot().conflicts()};
}

bool Session::Implementation::anyLive() const {
  const CandidateSet no = dialogue_.with(Knowledge::NotWanted);
  const auto& conflicts = robot().conflicts();
  return std::any_of(conflicts.begin(), conflicts.end(),
                     [&](const Conflict& conflict) { return !conflict.members.intersects(no); });
}

void Session::Implementation::decide() {
  if (concludeNoPlan()) return;
  // With no conflict left that is not hit, everything not answered NO should have a plan. Where it
  // has none, a conflict comes to light, and the next turn asks inside it.
  while (!anyLive()) {
    if (concludePlan()) return;
    if (concludeNoPlan()) return;
  }
  if (concludeBlocked()) return;
  if (const auto choice = policy_->next(situation())) {
    ask(*choice);
  } else if (options_.unsure_policy == UnsurePolicy::Defer && dialogue_.reopenUnsure()) {
    decide();
  } else {
    throw LimitReached(LimitReason::States,
                       "every question is answered, and the rest of the search");
  }
}

bool Session::Implementation::concludeNoPlan() {
  const CandidateSet wanted = dialogue_.with(Knowledge::Wanted);
  if (!robot().complete()) {
    // A conflict nobody knows yet may lie among what is wanted.
    const Check check = robot().check(wanted, limits());
    if (check.limit == LimitReason::Cancelled || check.limit == LimitReason::Time) {
      throw LimitReached(check.limit, "the search for a plan");
    }
    if (check.verdict == Verdict::Unknown) robot().suspect(wanted);
  }
  const Conflict* conflict = robot().provenConflictWithin(wanted);
  if (conflict == nullptr) return false;
  Outcome outcome;
  outcome.code = OutcomeCode::ExpectationUnachievable;
  outcome.conflict = fluents(conflict->members);
  outcome.message =
      "proven: no plan achieves what was asked for together with " + listed(outcome.conflict);
  outcome.alternatives = alternatives();
  finish(std::move(outcome));
  return true;
}

/// Tries to plan for everything not answered NO; false when a conflict was found instead.
bool Session::Implementation::concludePlan() {
  const CandidateSet wished = ~dialogue_.with(Knowledge::NotWanted);
  const Check check = robot().check(wished, limits());
  if (check.verdict == Verdict::Achievable) {
    conclude(wished, check.plan);
    return true;
  }
  if (check.verdict == Verdict::Unachievable) return false;
  if (check.limit == LimitReason::Cancelled || check.limit == LimitReason::Time ||
      !policy_->usesConflicts()) {
    throw LimitReached(check.limit, "the search for a plan");
  }
  robot().suspect(wished);
  return false;
}

/// A live conflict without open candidates can't be hit any more: no plan will be found.
bool Session::Implementation::concludeBlocked() {
  const questions::Situation now = situation();
  const CandidateSet unsure = dialogue_.with(Knowledge::Unsure);
  for (const Conflict& conflict : now.conflicts) {
    if (!now.isLive(conflict) || now.openMembers(conflict) > 0) continue;
    if (conflict.members.intersects(unsure)) {
      if (options_.unsure_policy == UnsurePolicy::Defer && dialogue_.reopenUnsure()) return false;
      Outcome outcome;
      outcome.code = OutcomeCode::UnsureBlocks;
      outcome.conflict = fluents(conflict.members);
      outcome.message = "what is wanted can't be had all together; it depends on " +
                        listed(fluents(conflict.members & unsure));
      finish(std::move(outcome));
    } else {
      Outcome outcome;
      outcome.code = outcomeOf(robot().lastLimit());
      outcome.conflict = fluents(conflict.members);
      outcome.message =
          "I could not find out within the limits whether all this can be had together: " +
          listed(outcome.conflict);
      finish(std::move(outcome));
    }
    return true;
  }
  return false;
}

void Session::Implementation::ask(const questions::Choice& choice) {
  const std::size_t asked = dialogue_.askedWith(choice.candidate);
  if (options_.max_questions >= 0 &&
      asked > asked_before_ + static_cast<std::size_t>(options_.max_questions)) {
    finish(OutcomeCode::QuestionLimit,
           "the limit of questions is reached, and the outcome still depends on " +
               dialogue_.fluents()[choice.candidate].text());
    return;
  }
  const Conflict* conflict = choice.conflict ? &robot().conflicts()[*choice.conflict] : nullptr;
  QuestionView view;
  view.asked = asked - 1;
  view.max_remaining = mostRemaining();
  view.bound_is_provisional = !robot().complete();
  dialogue_.ask(choice.candidate, conflict);
  view.fluents = {dialogue_.fluents()[choice.candidate]};
  view.conflict = dialogue_.openConflict();
  view.conflict_proven = dialogue_.openConflictProven();
  view.probabilities = {beliefs_[choice.candidate]};
  question_ = std::move(view);
  state_ = State::AwaitingAnswer;
}

std::size_t Session::Implementation::mostRemaining() const {
  CandidateSet askable = ~robot().alwaysTrue();
  if (policy_->usesConflicts() && robot().complete()) {
    askable.reset();
    const CandidateSet no = dialogue_.with(Knowledge::NotWanted);
    for (const Conflict& conflict : robot().conflicts()) {
      if (!conflict.members.intersects(no)) askable |= conflict.members;
    }
  } else if (!policy_->usesConflicts()) {
    askable.set();
  }
  return (askable & dialogue_.with(Knowledge::Open)).count();
}

void Session::Implementation::conclude(const CandidateSet& achieved, const task::Plan& first_plan) {
  const auto began = Limits::Clock::now();
  Outcome outcome;
  outcome.code = OutcomeCode::Success;
  outcome.plan = finalPlan(achieved, first_plan);
  outcome.message = "the plan achieves what was asked for and all that was not answered no";
  std::vector<Literal> promised = problem_->specified;
  const std::vector<Literal> kept = fluents(achieved);
  promised.insert(promised.end(), kept.begin(), kept.end());
  const auto fault = validation::fault(problem_->robot, outcome.plan.steps, promised, cancelOnly());
  if (fault) throw Exception("the plan found did not pass validation: " + *fault);
  finish(std::move(outcome));
  const std::chrono::duration<double> took = Limits::Clock::now() - began;
  statistics_.plan += took.count();
}

FinalPlan Session::Implementation::finalPlan(const CandidateSet& achieved,
                                             const task::Plan& first_plan) {
  FinalPlan plan;
  plan.steps = task::names(robot().task(), first_plan);
  const std::vector<Literal> kept = fluents(achieved);
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
  } else if (robot_side_.human_plan_runs) {
    // The person's own plan is the one to prefer where it gives all that is needed.
    std::vector<Literal> all = problem_->specified;
    all.insert(all.end(), kept.begin(), kept.end());
    if (!validation::fault(problem_->robot, problem_->human_plan, all, cancelOnly())) {
      plan.steps = problem_->human_plan;
    }
  }
  const validation::Execution execution =
      validation::execute(problem_->robot, plan.steps, cancelOnly());
  plan.cost = unit_costs_ ? static_cast<std::int64_t>(plan.steps.size()) : execution.cost();
  plan.guaranteed = problem_->specified;
  const CandidateSet asked = dialogue_.with(Knowledge::Wanted) | dialogue_.with(Knowledge::Unsure);
  const std::vector<Literal> wanted = fluents(asked);
  plan.guaranteed.insert(plan.guaranteed.end(), wanted.begin(), wanted.end());
  plan.kept_unasked = fluents(achieved - asked - dialogue_.with(Knowledge::NotWanted));
  plan.not_wanted = fluents(dialogue_.with(Knowledge::NotWanted));
  return plan;
}

/// Everything wanted but as little as will do to have the rest, likeliest first.
std::vector<Alternative> Session::Implementation::alternatives() {
  std::vector<Alternative> result;
  const CandidateSet wanted = dialogue_.with(Knowledge::Wanted);
  for (const CandidateSet& given_up :
       robot().alternatives(wanted, beliefs_, kMostAlternatives, limits())) {
    Alternative alternative;
    alternative.given_up = fluents(given_up);
    alternative.probability = 1;
    for (const std::size_t f : achievability::members(given_up)) {
      alternative.probability *= 1 - beliefs_[f];
    }
    result.push_back(std::move(alternative));
  }
  return result;
}

std::vector<Literal> Session::Implementation::fluents(const CandidateSet& set) const {
  std::vector<Literal> result;
  for (const std::size_t f : achievability::members(set))
    result.push_back(dialogue_.fluents()[f]);
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
