// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/common/parallel.h"
#include "goal_alignment/search/exhaustive.h"
#include "goal_alignment/search/greedy.h"

/// The part of Achievability that proves: the exhaustive search (stage 3), the way from an
/// unachievable set to a minimal conflict, and the enumeration of all conflicts.
namespace goal_alignment::achievability {

using task::FactId;
using task::FactSet;

namespace {

/// Beyond so many maximal sets left to confirm, "complete" would take too long to establish.
constexpr std::size_t kMostHittingSets = 5000;
/// Nor can so many conflicts be looked at one by one.
constexpr std::size_t kMostConflicts = 10'000;

}  // namespace

/// Stage 3: all reachable states, after which every check is answered without a search. None: that
/// worked out.
LimitReason Achievability::sweep(const Limits& limits) {
  const auto is_final = [](LimitReason reason) {
    return reason != LimitReason::States && reason != LimitReason::Memory;
  };
  sweep_limit_ = sweepSymbolically(budget_.first_symbolic, limits);
  if (!is_final(sweep_limit_)) sweep_limit_ = exhaust(limits);
  if (!is_final(sweep_limit_)) sweep_limit_ = sweepSymbolically(budget_.symbolic, limits);
  // What a person or the clock broke off must end now, and may be tried anew; states and bytes
  // would end it again.
  swept_ = sweep_limit_ != LimitReason::Cancelled && sweep_limit_ != LimitReason::Time;
  return sweep_limit_;
}

/// The reachable states as a decision diagram. It may hold half of the memory.
LimitReason Achievability::sweepSymbolically(std::uint64_t steps, const Limits& limits) {
  ++planner_calls_;
  Limits own = limits.withStates(steps);
  own.bytes = limits.bytes / 2;
  auto symbolic = std::make_unique<search::Symbolic>(task_->task(), task_->groups());
  const LimitReason reason = symbolic->run(own);
  if (reason == LimitReason::None) symbolic_ = std::move(symbolic);
  return reason;
}

/// With the reachable states at hand a check is a matter of looking; only a plan must be found.
Check Achievability::checkReachable(const CandidateSet& set, const Limits& limits) {
  if (!symbolic_->reachable(goalWith(set))) {
    addUnachievable(set, limits);
    return {Verdict::Unachievable, {}, {}};
  }
  Check last;
  const Limits second = limits.withStates(budget_.second_greedy);
  if (const auto found = searchGreedily(set, second, last)) return *found;
  if (last.limit == LimitReason::States) {
    if (const auto plan = symbolic_->plan(goalWith(set), limits)) {
      recordPlan(*plan);
      return {Verdict::Achievable, *plan, {}};
    }
  }
  last_limit_ = last.limit;
  return last;
}

/// Visits every reachable state, keeps the maximal achieved sets.
LimitReason Achievability::exhaust(const Limits& limits) {
  ++planner_calls_;
  search::Exhaustive exhaustive(*task_);
  std::unordered_map<CandidateSet, search::StateId> first_seen;
  std::vector<std::pair<CandidateSet, search::StateId>> maximal;
  const auto visit = [&](search::StateId id, const task::Word* state) {
    const bool satisfies_goal = task::satisfies(state, specified_);
    if (!satisfies_goal && reached_.all()) return true;
    CandidateSet now = satisfied(state);
    reached_ |= now;
    if (!satisfies_goal || !first_seen.emplace(now, id).second) return true;
    const auto covers = [&](const auto& entry) { return now.is_subset_of(entry.first); };
    if (std::any_of(maximal.begin(), maximal.end(), covers)) return true;
    const auto covered = [&](const auto& entry) { return entry.first.is_subset_of(now); };
    maximal.erase(std::remove_if(maximal.begin(), maximal.end(), covered), maximal.end());
    maximal.emplace_back(std::move(now), id);
    return true;
  };
  const LimitReason reason = exhaustive.run(limits.withStates(budget_.exhaustive), visit);
  if (reason == LimitReason::Cancelled || reason == LimitReason::Time) return reason;
  std::vector<AchievedSets::Achieved> achieved;
  achieved.reserve(maximal.size());
  for (const auto& [set, id] : maximal) {
    achieved.push_back({set, exhaustive.plan(id)});
    conflicts_.clearSuspectedWithin(set);
  }
  achieved_.addMaximal(std::move(achieved));
  exhaustive_complete_ = reason == LimitReason::None;
  return reason;
}

/// Whether a set is proven unachievable, by memory or by a search of the first budget.
bool Achievability::provenUnachievable(const CandidateSet& set, const Limits& limits) {
  if (conflicts_.provenWithin(set) != nullptr) return true;
  if (achieved_.covering(set) != nullptr) return false;
  if (exhaustive_complete_) return true;
  if (knowsReachable()) return !symbolic_->reachable(goalWith(set));
  ++planner_calls_;
  const search::Result result =
      search::greedy(*task_, goalWith(set), limits.withStates(budget_.first_greedy));
  if (result.status == search::Status::Solved) recordPlan(result.plan);
  return result.status == search::Status::Unsolvable;
}

/// Shrinks a set proven unachievable to a conflict by leaving out one candidate after the other
/// (deletion-based, as for minimal unsatisfiable subsets) and adds it.
void Achievability::addUnachievable(const CandidateSet& set, const Limits& limits) {
  Conflict conflict;
  conflict.members = set - always_true_;
  conflict.minimal = true;
  for (const std::size_t candidate : members(conflict.members)) {
    conflict.members.reset(candidate);
    if (provenUnachievable(conflict.members, limits)) continue;
    conflict.members.set(candidate);
    // Left in because it was not proven superfluous: minimal only if that was shown by a plan.
    CandidateSet without = conflict.members;
    without.reset(candidate);
    conflict.minimal =
        conflict.minimal && (knowsReachable() || achieved_.covering(without) != nullptr);
  }
  conflicts_.add(conflict);
}

void Achievability::suspect(const CandidateSet& set) {
  conflicts_.add({set - always_true_, false, false});
}

/// The first few maximal sets without a known conflict that are not known to be achievable.
std::vector<CandidateSet> Achievability::nextOpenSets(std::size_t most, bool& too_many) {
  std::vector<CandidateSet> open;
  const auto* hitting_sets = conflicts_.minimalHittingSets(kMostHittingSets);
  too_many = hitting_sets == nullptr;
  if (too_many) return open;
  for (const CandidateSet& hitting : *hitting_sets) {
    CandidateSet rest = ~hitting;
    if (achieved_.covering(rest) == nullptr) open.push_back(std::move(rest));
    if (open.size() == most) break;
  }
  return open;
}

/// Looks for plans for several sets side by side; true when all have one.
bool Achievability::checkTogether(const std::vector<CandidateSet>& sets, const Limits& limits) {
  std::vector<search::Result> results(sets.size());
  inParallel(sets.size(), budget_.threads, [&](std::size_t i) {
    results[i] = search::greedy(*task_, goalWith(sets[i]), limits.withStates(budget_.first_greedy));
  });
  planner_calls_ += sets.size();
  bool all = true;
  for (const search::Result& result : results) {
    if (result.status == search::Status::Solved) recordPlan(result.plan);
    all = all && result.status == search::Status::Solved;
  }
  return all;
}

/// All conflicts at once, from the reachable states.
bool Achievability::takeConflicts(const Limits& limits) {
  std::map<FactId, std::size_t> candidate_of;
  FactSet facts;
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    if (facts_[i] == kNoFact) continue;
    candidate_of.emplace(facts_[i], i);
    facts.push_back(facts_[i]);
  }
  const search::MinimalConflicts found = symbolic_->minimalConflicts(
      specified_, task::makeFactSet(std::move(facts)), kMostConflicts, limits);
  if (!found.all) return false;
  conflicts_.clearSuspectedWithin(~CandidateSet(facts_.size()));
  for (const FactSet& set : found.sets) {
    Conflict conflict;
    conflict.members.resize(facts_.size());
    for (const FactId fact : set)
      conflict.members.set(candidate_of.at(fact));
    conflicts_.add(conflict);
  }
  return true;
}

bool Achievability::findAllConflicts(const Limits& limits) {
  bool too_many = false;
  // Many sets at a time as long as all of them have plans; one whose plan is not found at once may
  // bring a conflict to light that settles others, too.
  std::size_t together = 1;
  while (!complete_) {
    if (knowsReachable() && takeConflicts(limits)) break;
    const std::vector<CandidateSet> open = nextOpenSets(together, too_many);
    if (open.empty()) break;
    if (open.size() > 1) {
      together = checkTogether(open, limits) ? kBatch : 1;
      continue;
    }
    const Check result = check(open.front(), limits);
    if (result.verdict == Verdict::Achievable) together = kBatch;
    if (result.verdict != Verdict::Unknown) continue;
    if (result.limit == LimitReason::Cancelled || result.limit == LimitReason::Time) return false;
    suspect(open.front());
  }
  const bool all_proven = std::all_of(conflicts().begin(), conflicts().end(),
                                      [](const Conflict& conflict) { return conflict.proven; });
  complete_ = !too_many && all_proven;
  if (complete_) conflicts_.markMinimal();
  return complete_;
}

}  // namespace goal_alignment::achievability
