// SPDX-License-Identifier: BSD-3-Clause
#include "extra_cost.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::session {

using achievability::CandidateSet;

namespace {

/// How many states each search for a cheaper plan may generate. A question that is asked needlessly
/// since a plan was not found is a nuisance, no fault.
constexpr std::uint64_t kStates = 20'000;

/// The same where nothing is decided by it: so many in a small task, fewer where each takes longer.
constexpr std::uint64_t kMaxBriefStates = 500;
constexpr std::uint64_t kMinBriefStates = 100;
constexpr std::uint64_t kBriefOperators = 4'000'000;

search::Improved improve(Analysis& analysis, const CandidateSet& set, const task::Plan& plan,
                         std::uint64_t states) {
  search::Improved best =
      analysis.robot().improvedPlan(set, plan, analysis.budget().limits().withStates(states));
  if (best.limit == LimitReason::Cancelled) throw LimitReached(best.limit, "the final plan");
  return best;
}

}  // namespace

bool costsMatter(const Options& options) {
  return !std::isinf(options.max_extra_cost);
}

search::Improved improveBriefly(Analysis& analysis, const CandidateSet& set,
                                const task::Plan& plan) {
  const std::size_t operators = std::max<std::size_t>(1, analysis.robot().task().operators.size());
  const std::uint64_t states =
      std::clamp<std::uint64_t>(kBriefOperators / operators, kMinBriefStates, kMaxBriefStates);
  return improve(analysis, set, plan, states);
}

CandidateSet trueAtEnd(const Analysis& analysis, const task::Plan& plan) {
  const alignment::Problem& problem = analysis.problem();
  const validation::Execution execution = validation::execute(
      problem.robot, task::names(analysis.robot().task(), plan), analysis.budget().cancelOnly());
  CandidateSet result(problem.candidates.size());
  for (std::size_t f = 0; f < result.size(); ++f) {
    result.set(f, validation::unsatisfied(problem.robot, execution.finalState(),
                                          {problem.candidates[f].fluent})
                      .empty());
  }
  return result;
}

std::vector<Dialogue::AskedCandidate> tooCostly(Analysis& analysis, const CandidateSet& kept,
                                                const CandidateSet& open, const task::Plan& plan,
                                                double max_extra_cost, std::size_t max_count) {
  std::vector<Dialogue::AskedCandidate> result;
  const search::Improved least = improve(analysis, kept, plan, kStates);
  const auto extra = [&](task::Cost cost) { return cost - least.cost; };
  const auto is_let_pass = [&](task::Cost cost) {
    return static_cast<double>(extra(cost)) <= max_extra_cost;
  };
  if (is_let_pass(task::cost(analysis.robot().task(), plan))) return result;
  CandidateSet free = analysis.robot().alwaysTrue() | trueAtEnd(analysis, least.plan);
  std::vector<std::size_t> left = achievability::members(open - free);
  const std::vector<double>& beliefs = analysis.beliefs();
  std::stable_sort(left.begin(), left.end(),
                   [&](std::size_t a, std::size_t b) { return beliefs[a] < beliefs[b]; });
  for (const std::size_t candidate : left) {
    if (result.size() == max_count) break;
    if (free.test(candidate)) continue;
    CandidateSet with = kept;
    with.set(candidate);
    const search::Improved dearer = improve(analysis, with, plan, kStates);
    if (is_let_pass(dearer.cost))
      free |= trueAtEnd(analysis, dearer.plan);
    else
      result.push_back({candidate, Reason{{}, true, extra(dearer.cost), false}});
  }
  return result;
}

}  // namespace goal_alignment::session
