// SPDX-License-Identifier: BSD-3-Clause
#include "goal_set_prover.h"

#include <utility>

#include "shrunk.h"

namespace goal_alignment::achievability {

Check GoalSetProver::check(const CandidateSet& set, const Limits& limits) {
  if (const auto known = knowledge_.recall(set)) return *known;
  Check result = prove(set, limits);
  if (result.verdict == Verdict::Unknown) result = refineUnknown(set, std::move(result), limits);
  return result;
}

Check GoalSetProver::prove(const CandidateSet& set, const Limits& limits) {
  Attempt attempt = {set, limits, reachable_.sweepIsDue(limits)};
  using Stage = std::optional<Check> (GoalSetProver::*)(Attempt&);
  constexpr Stage kStages[] = {
      &GoalSetProver::searchBeforeSweep,  // first_greedy
      &GoalSetProver::sweep,              // first_symbolic, exhaustive, symbolic; once for all sets
      &GoalSetProver::lookUp,             // no budget; ends here where the sweep came to its end
      &GoalSetProver::searchAfterSweep,   // second_greedy
  };
  for (const Stage stage : kStages) {
    if (auto answer = (this->*stage)(attempt)) return *std::move(answer);
  }
  // The states of a search are our own budget: with more memory the sweep would have answered.
  if (attempt.limit == LimitReason::States && reachable_.sweepLimit() == LimitReason::Memory) {
    attempt.limit = LimitReason::Memory;
  }
  return {Verdict::Unknown, {}, attempt.limit};
}

std::optional<Check> GoalSetProver::searchBeforeSweep(Attempt& attempt) {
  if (!attempt.sweep_is_due) return std::nullopt;
  return searchGreedily(attempt.set, attempt.limits.withStates(budget_.first_greedy),
                        attempt.limit);
}

std::optional<Check> GoalSetProver::sweep(Attempt& attempt) {
  if (!attempt.sweep_is_due) return std::nullopt;
  attempt.limit = reachable_.sweep(attempt.limits);
  return knowledge_.recall(attempt.set);
}

/// With the reachable states at hand only a plan has to be searched for.
std::optional<Check> GoalSetProver::lookUp(Attempt& attempt) {
  const CandidateSet& set = attempt.set;
  const Limits& limits = attempt.limits;
  if (!reachable_.enumerated() && !reachable_.haveDiagram()) return std::nullopt;
  if (reachable_.enumerated() || !reachable_.satisfy(task_.goalWith(set))) {
    minimiser_.learnUnachievable(set, limits);
    return Check{Verdict::Unachievable, {}, {}};
  }
  LimitReason limit = LimitReason::None;
  const Limits second = limits.withStates(budget_.second_greedy);
  if (auto found = searchGreedily(set, second, limit)) return found;
  if (limit == LimitReason::States) {
    if (const auto plan = reachable_.planFor(task_.goalWith(set), limits)) {
      knowledge_.learnPlan(*plan);
      return Check{Verdict::Achievable, *plan, {}};
    }
  }
  return Check{Verdict::Unknown, {}, limit};
}

std::optional<Check> GoalSetProver::searchAfterSweep(Attempt& attempt) {
  const bool interrupted =
      attempt.limit == LimitReason::Cancelled || attempt.limit == LimitReason::Time;
  if (interrupted) return std::nullopt;
  return searchGreedily(attempt.set, attempt.limits.withStates(budget_.second_greedy),
                        attempt.limit);
}

/// The answer, or nothing and in `limit` what ended the search.
std::optional<Check> GoalSetProver::searchGreedily(const CandidateSet& set, const Limits& limits,
                                                   LimitReason& limit) {
  const search::Result result = planner_.greedy(task_.goalWith(set), limits);
  auto answer = learnFrom(set, result, limits);
  if (!answer) limit = result.limit;
  return answer;
}

/// What a search says of the set; nothing where a limit ended it.
std::optional<Check> GoalSetProver::learnFrom(const CandidateSet& set, const search::Result& result,
                                              const Limits& limits) {
  if (result.status == search::Status::LimitReached) return std::nullopt;
  if (result.status == search::Status::Solved) {
    knowledge_.learnPlan(result.plan);
    return Check{Verdict::Achievable, result.plan, {}};
  }
  minimiser_.learnUnachievable(set, limits);
  return Check{Verdict::Unachievable, {}, {}};
}

/// The budgets left a set undecided: looks for what in it makes it so, and suspects that.
Check GoalSetProver::refineUnknown(const CandidateSet& set, Check last, const Limits& limits) {
  // What a small budget leaves undecided may be no conflict, which a full search then tells. Each
  // time something is learnt, so another attempt may end elsewhere; but each takes its time, too.
  constexpr int kAttempts = 3;
  const CandidateSet whole = set - task_.alwaysTrue();
  CandidateSet undecided = whole;
  for (int attempt = 0; attempt < kAttempts && isOwnBudget(last.limit); ++attempt) {
    undecided = shrunk(
        whole, [&](const CandidateSet& smaller) { return remainsUndecided(smaller, limits); });
    const bool settled = settle(undecided, whole, limits);
    if (const auto known = knowledge_.recall(set)) return *known;
    if (!settled) break;
    undecided = whole;
  }
  const LimitReason interrupted = limits.interruption();
  if (interrupted != LimitReason::None) last.limit = interrupted;
  if (isOwnBudget(last.limit)) knowledge_.suspect(undecided);
  return last;
}

/// Whether a small budget finds no plan for a subset of an undecided set.
bool GoalSetProver::remainsUndecided(const CandidateSet& set, const Limits& limits) {
  if (const auto known = knowledge_.recall(set)) return known->verdict == Verdict::Unachievable;
  LimitReason limit = LimitReason::None;
  const auto found = searchGreedily(set, limits.withStates(budget_.shrinking), limit);
  if (found) return found->verdict == Verdict::Unachievable;
  return isOwnBudget(limit);
}

/// Tries to decide the set after all: from parts of the task, and with all stages unless it is the
/// whole set, which has gone through them before.
bool GoalSetProver::settle(const CandidateSet& undecided, const CandidateSet& whole,
                           const Limits& limits) {
  const Limits own = limits.withStates(budget_.parts);
  if (learnFrom(undecided, planner_.inParts(undecided, own), limits)) return true;
  return undecided != whole && prove(undecided, limits).verdict != Verdict::Unknown;
}

}  // namespace goal_alignment::achievability
