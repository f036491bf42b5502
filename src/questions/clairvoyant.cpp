// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/clairvoyant.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace goal_alignment::questions {

using achievability::CandidateSet;
using achievability::Conflict;

namespace {

using Sets = std::vector<CandidateSet>;

void keepMinimal(Sets& sets) {
  std::sort(sets.begin(), sets.end(), [](const CandidateSet& a, const CandidateSet& b) {
    return a.count() != b.count() ? a.count() < b.count() : a < b;
  });
  Sets minimal;
  for (CandidateSet& set : sets) {
    if (std::none_of(minimal.begin(), minimal.end(),
                     [&](const CandidateSet& within) { return within.is_subset_of(set); })) {
      minimal.push_back(std::move(set));
    }
  }
  sets = std::move(minimal);
}

/// A lower bound: sets that share nothing need a member each. Takes small ones first, as
/// keepMinimal() sorts them.
std::size_t disjointSets(const Sets& sets) {
  std::size_t count = 0;
  CandidateSet used(sets.front().size());
  for (const CandidateSet& set : sets) {
    if (set.intersects(used)) continue;
    used |= set;
    ++count;
  }
  return count;
}

Sets without(const Sets& sets, std::size_t member) {
  Sets rest;
  std::copy_if(sets.begin(), sets.end(), std::back_inserter(rest),
               [member](const CandidateSet& set) { return !set.test(member); });
  return rest;
}

/// The size of the smallest set that hits all, if it is below `bound`; else `bound`.
std::size_t smallestHittingSet(Sets sets, std::size_t bound) {
  if (sets.empty()) return 0;
  keepMinimal(sets);
  if (disjointSets(sets) >= bound) return bound;
  const CandidateSet branching = sets.front();
  std::vector<std::pair<std::size_t, std::size_t>> by_degree;
  for (const std::size_t f : achievability::members(branching)) {
    const auto with = std::count_if(sets.begin(), sets.end(),
                                    [f](const CandidateSet& set) { return set.test(f); });
    by_degree.emplace_back(sets.size() - static_cast<std::size_t>(with), f);
  }
  std::sort(by_degree.begin(), by_degree.end());
  for (const auto& [left, f] : by_degree) {
    bound = std::min(bound, 1 + smallestHittingSet(without(sets, f), bound - 1));
    // From here on, without it.
    for (CandidateSet& set : sets)
      set.reset(f);
    if (sets.front().none() || disjointSets(sets) >= bound) break;
  }
  return bound;
}

}  // namespace

std::size_t clairvoyantMinimum(const std::vector<Conflict>& conflicts, const CandidateSet& wanted) {
  std::optional<std::size_t> smallest;
  Sets to_hit;
  for (const Conflict& conflict : conflicts) {
    if (conflict.members.is_subset_of(wanted)) {
      smallest = std::min(smallest.value_or(conflict.members.count()), conflict.members.count());
    }
    to_hit.push_back(conflict.members - wanted);
  }
  if (smallest) return *smallest;
  return smallestHittingSet(std::move(to_hit), wanted.size() + 1);
}

}  // namespace goal_alignment::questions
