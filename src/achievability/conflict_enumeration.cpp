// SPDX-License-Identifier: BSD-3-Clause
#include "conflict_enumeration.h"

#include <utility>

#include "goal_alignment/common/parallel.h"

namespace goal_alignment::achievability {

LimitReason ConflictEnumeration::run(const Limits& limits) {
  LimitReason last_limit = LimitReason::None;
  const bool explored = explore(limits, last_limit);
  knowledge_.concludeEnumeration(explored);
  return last_limit;
}

/// Looks at unexplored sets until none is left, which is what true says.
bool ConflictEnumeration::explore(const Limits& limits, LimitReason& last_limit) {
  // Many sets at a time as long as all of them have plans. A set whose plan is not found at once is
  // checked alone, since it may bring a conflict to light that settles others, too.
  std::size_t max_sets = 1;
  bool listed = false;
  for (std::uint64_t looked_at = 0; !knowledge_.complete() && looked_at < budget_.open_sets;) {
    if (reachable_.haveDiagram() && !std::exchange(listed, true) && listFromDiagram(limits))
      return true;
    const SubsetMap::Unexplored open = knowledge_.unexplored(max_sets, limits);
    if (open.limit != LimitReason::None) last_limit = open.limit;
    if (open.limit != LimitReason::None) return false;
    if (open.sets.empty()) return true;
    looked_at += open.sets.size();
    if (open.sets.size() > 1) {
      max_sets = planForEach(open.sets, limits) ? kBatch : 1;
      continue;
    }
    const Check check = prover_.check(open.sets.front(), limits);
    if (check.verdict == Verdict::Achievable) max_sets = kBatch;
    if (check.verdict != Verdict::Unknown) continue;
    last_limit = check.limit;
    if (!isOwnBudget(check.limit)) return false;
  }
  if (!knowledge_.complete()) last_limit = LimitReason::States;
  return knowledge_.complete();
}

bool ConflictEnumeration::listFromDiagram(const Limits& limits) {
  const auto conflicts = reachable_.minimalConflicts(limits);
  if (conflicts) knowledge_.learnAllConflicts(*conflicts);
  return conflicts.has_value();
}

/// Looks for plans for several sets side by side; true when all have one.
bool ConflictEnumeration::planForEach(const std::vector<CandidateSet>& sets, const Limits& limits) {
  std::vector<task::Goal> goals;
  goals.reserve(sets.size());
  for (const CandidateSet& set : sets)
    goals.push_back(task_.goalWith(set));
  bool all = true;
  for (const search::Result& result :
       planner_.greedyForEach(goals, limits.withStates(budget_.first_greedy))) {
    if (result.status == search::Status::Solved) knowledge_.learnPlan(result.plan);
    all = all && result.status == search::Status::Solved;
  }
  return all;
}

}  // namespace goal_alignment::achievability
