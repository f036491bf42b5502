// SPDX-License-Identifier: BSD-3-Clause
#include "auto_policy.h"

#include <tuple>
#include <vector>

namespace goal_alignment::questions {

using achievability::Conflict;

namespace {

std::size_t liveConflictsWith(const Situation& situation, std::size_t candidate) {
  std::size_t count = 0;
  for (const Conflict& conflict : situation.conflicts) {
    if (conflict.members.test(candidate) && situation.isLive(conflict)) ++count;
  }
  return count;
}

/// The live conflict with the fewest open candidates (at least one), proven ones first.
std::optional<std::size_t> smallestOpenConflict(const Situation& situation) {
  std::optional<std::size_t> best;
  std::tuple<bool, std::size_t> best_key;
  for (std::size_t i = 0; i < situation.conflicts.size(); ++i) {
    const Conflict& conflict = situation.conflicts[i];
    const std::size_t open = situation.openMembers(conflict);
    if (open == 0 || !situation.isLive(conflict)) continue;
    const auto key = std::make_tuple(!conflict.proven, open);
    if (best && best_key <= key) continue;
    best = i;
    best_key = key;
  }
  return best;
}

}  // namespace

std::optional<Choice> AutoPolicy::next(const Situation& situation) {
  const auto conflict = smallestOpenConflict(situation);
  if (!conflict) return std::nullopt;
  std::vector<std::size_t> best;
  std::tuple<double, std::size_t> best_key;
  for (const std::size_t f : achievability::members(situation.conflicts[*conflict].members)) {
    if (situation.knowledge[f] != Knowledge::Open) continue;
    // More conflicts settled by one NO is better, hence the subtraction.
    const auto key = std::make_tuple(situation.probability[f],
                                     situation.conflicts.size() - liveConflictsWith(situation, f));
    if (!best.empty() && best_key < key) continue;
    if (best.empty() || key < best_key) best.clear();
    best_key = key;
    best.push_back(f);
  }
  return Choice{best[random_.below(best.size())], conflict};
}

}  // namespace goal_alignment::questions
