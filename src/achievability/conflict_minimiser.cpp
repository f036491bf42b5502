// SPDX-License-Identifier: BSD-3-Clause
#include "conflict_minimiser.h"

#include <algorithm>
#include <vector>

#include "shrunk.h"

namespace goal_alignment::achievability {

void ConflictMinimiser::learnUnachievable(const CandidateSet& set, const Limits& limits) {
  const auto still_unachievable = [&](const CandidateSet& smaller) {
    std::uint64_t states = budget_.first_greedy;
    return provenUnachievable(smaller, states, limits);
  };
  learnTested(shrunk(set - task_.alwaysTrue(), still_unachievable), limits);
}

/// Whether a set is proven unachievable, from memory or by a search, which takes from `states`.
bool ConflictMinimiser::provenUnachievable(const CandidateSet& set, std::uint64_t& states,
                                           const Limits& limits) {
  if (knowledge_.provenConflictWithin(set) != nullptr) return true;
  if (knowledge_.hasPlanFor(set)) return false;
  if (reachable_.enumerated()) return true;
  if (reachable_.haveDiagram()) return !reachable_.satisfy(task_.goalWith(set));
  if (states == 0) return false;
  const search::Result result = planner_.greedy(task_.goalWith(set), limits.withStates(states));
  states -= std::min(states, result.statistics.generated);
  if (result.status == search::Status::Solved) knowledge_.learnPlan(result.plan);
  return result.status == search::Status::Unsolvable;
}

/// Learns a conflict that can do without none of its members as far as could be proven. It is
/// minimal only where plans show it: what is left in may just not have been proven superfluous.
void ConflictMinimiser::learnTested(const CandidateSet& conflict, const Limits& limits) {
  if (limits.interruption() == LimitReason::None) tested_.insert(conflict);
  const std::vector<std::size_t> all = members(conflict);
  const bool minimal = std::all_of(all.begin(), all.end(), [&](std::size_t candidate) {
    CandidateSet without = conflict;
    return reachable_.haveDiagram() || knowledge_.hasPlanFor(without.reset(candidate));
  });
  knowledge_.learnConflict({conflict, true, minimal});
}

/// Tests a proven conflict without each of its members: the first time by searching, later by what
/// is known. True: a smaller one has taken its place.
bool ConflictMinimiser::replaceBySmaller(const CandidateSet& conflict, const Limits& limits) {
  if (knowledge_.complete()) return false;
  const std::vector<std::size_t> all = members(conflict);
  std::uint64_t left = tested_.count(conflict) == 0 ? budget_.minimising : 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    CandidateSet without = conflict;
    const std::uint64_t share = left / (all.size() - i);
    std::uint64_t unused = share;
    if (provenUnachievable(without.reset(all[i]), unused, limits)) {
      learnUnachievable(without, limits);
      return true;
    }
    left -= share - unused;
  }
  learnTested(conflict, limits);
  return false;
}

const Conflict* ConflictMinimiser::smallConflictWithin(CandidateSet set, const Limits& limits) {
  while (const Conflict* conflict = knowledge_.provenConflictWithin(set)) {
    set = conflict->members;
    if (!replaceBySmaller(set, limits)) return knowledge_.provenConflictWithin(set);
  }
  return nullptr;
}

}  // namespace goal_alignment::achievability
