// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/task/state.h"
#include "implementation.h"

/// A plan keeps everything that was not answered NO, and that can make a robot do visible nonsense
/// for things nobody cares about. Here is what keeping them costs.
namespace goal_alignment::session {

using achievability::CandidateSet;
using questions::Knowledge;

namespace {

/// How many states each search for a cheaper plan may generate. A question that is asked needlessly
/// since a plan was not found is a nuisance, no fault.
constexpr std::uint64_t kStates = 20'000;

/// The same where nothing is decided by it: so many in a small task, fewer where each takes longer.
constexpr std::uint64_t kStatesToTell = 500;
constexpr std::uint64_t kMinStates = 100;
constexpr std::uint64_t kOperatorsToTell = 4'000'000;

}  // namespace

/// Whether something may have to be asked about for its cost alone.
bool Session::Implementation::costsMatter() const {
  return !std::isinf(options_.max_extra_cost);
}

/// A plan for fewer things, made cheaper as far as so many states let.
search::Improved Session::Implementation::cheapened(const CandidateSet& set, const task::Plan& plan,
                                                    std::uint64_t states) {
  search::Improved best = robot().improvedPlan(set, plan, limits().withStates(states));
  if (best.limit == LimitReason::Cancelled) throw LimitReached(best.limit, "the final plan");
  return best;
}

/// The same as far as a short search finds it.
search::Improved Session::Implementation::cheaply(const CandidateSet& set, const task::Plan& plan) {
  const std::size_t operators = std::max<std::size_t>(1, robot().task().operators.size());
  const std::uint64_t states =
      std::clamp<std::uint64_t>(kOperatorsToTell / operators, kMinStates, kStatesToTell);
  return cheapened(set, plan, states);
}

CandidateSet Session::Implementation::trueAtEnd(const task::Plan& plan) const {
  const validation::Execution execution =
      validation::execute(problem_->robot, task::names(robot().task(), plan), cancelOnly());
  CandidateSet result(robot().candidateCount());
  for (std::size_t f = 0; f < result.size(); ++f) {
    result.set(f, validation::unsatisfied(problem_->robot, execution.finalState(),
                                          {dialogue_.fluents()[f]})
                      .empty());
  }
  return result;
}

/// Those of `open` that each cost more than is let pass to have besides `kept`, `most` at most, the
/// least likely first. The plan has all of both.
std::vector<Dialogue::AskedCandidate> Session::Implementation::tooCostly(const CandidateSet& kept,
                                                                         const CandidateSet& open,
                                                                         const task::Plan& plan,
                                                                         std::size_t most) {
  std::vector<Dialogue::AskedCandidate> result;
  const search::Improved least = cheapened(kept, plan, kStates);
  const auto extra = [&](task::Cost cost) { return cost - least.cost; };
  const auto passes = [&](task::Cost cost) {
    return static_cast<double>(extra(cost)) <= options_.max_extra_cost;
  };
  if (passes(task::cost(robot().task(), plan))) return result;
  CandidateSet free = robot().alwaysTrue() | trueAtEnd(least.plan);
  std::vector<std::size_t> left = achievability::members(open - free);
  std::stable_sort(left.begin(), left.end(),
                   [this](std::size_t a, std::size_t b) { return beliefs_[a] < beliefs_[b]; });
  for (const std::size_t candidate : left) {
    if (result.size() == most) break;
    if (free.test(candidate)) continue;
    CandidateSet with = kept;
    with.set(candidate);
    const search::Improved dearer = cheapened(with, plan, kStates);
    if (passes(dearer.cost))
      free |= trueAtEnd(dearer.plan);
    else
      result.push_back({candidate, Reason{{}, true, extra(dearer.cost), false}});
  }
  return result;
}

/// Asks about a candidate that nobody asked for and that costs more than is let pass; false where
/// there is none.
bool Session::Implementation::askAboutCost(const CandidateSet& wished, const task::Plan& plan) {
  if (!costsMatter()) return false;
  const CandidateSet kept = dialogue_.with(Knowledge::Wanted) | dialogue_.with(Knowledge::Unsure);
  const auto posed = tooCostly(kept, wished & dialogue_.with(Knowledge::Open), plan, 1);
  if (posed.empty()) return false;
  ask(posed);
  return true;
}

}  // namespace goal_alignment::session
