// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/search/exhaustive.h"
#include "goal_alignment/search/greedy.h"

/// The part of Achievability that proves: the exhaustive search (stage 3), the way from an
/// unachievable set to a minimal conflict, and the enumeration of all conflicts.
namespace goal_alignment::achievability {

namespace {

/// Beyond so many maximal sets left to confirm, "complete" would take too long to establish.
constexpr std::size_t kMostHittingSets = 5000;

}  // namespace

/// Stage 3: visits every reachable state, keeps the maximal achieved sets. After it every check is
/// answered from memory.
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
  exhaustive_limit_ = reason;
  // What a person or the clock broke off must end now, and may be tried anew; states and bytes
  // would end it again.
  exhaustive_tried_ = reason != LimitReason::Cancelled && reason != LimitReason::Time;
  if (!exhaustive_tried_) return reason;
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
    conflict.minimal = conflict.minimal && achieved_.covering(without) != nullptr;
  }
  conflicts_.add(conflict);
}

void Achievability::suspect(const CandidateSet& set) {
  conflicts_.add({set - always_true_, false, false});
}

/// A maximal set without a known conflict that is not known to be achievable.
std::optional<CandidateSet> Achievability::nextOpenSet(bool& too_many) {
  const auto* hitting_sets = conflicts_.minimalHittingSets(kMostHittingSets);
  too_many = hitting_sets == nullptr;
  if (too_many) return std::nullopt;
  for (const CandidateSet& hitting : *hitting_sets) {
    CandidateSet rest = ~hitting;
    if (achieved_.covering(rest) == nullptr) return rest;
  }
  return std::nullopt;
}

bool Achievability::findAllConflicts(const Limits& limits) {
  bool too_many = false;
  while (!complete_) {
    const auto open = nextOpenSet(too_many);
    if (!open) break;
    const Check result = check(*open, limits);
    if (result.verdict != Verdict::Unknown) continue;
    if (result.limit == LimitReason::Cancelled || result.limit == LimitReason::Time) return false;
    suspect(*open);
  }
  const bool all_proven = std::all_of(conflicts().begin(), conflicts().end(),
                                      [](const Conflict& conflict) { return conflict.proven; });
  complete_ = !too_many && all_proven;
  if (complete_) conflicts_.markMinimal();
  return complete_;
}

}  // namespace goal_alignment::achievability
