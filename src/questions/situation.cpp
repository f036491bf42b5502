// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <tuple>

#include "goal_alignment/questions/policy.h"
#include "live_conflict.h"

namespace goal_alignment::questions {

using achievability::Conflict;

bool Situation::isLive(const Conflict& conflict) const {
  const auto hit = achievability::members(conflict.members);
  return std::none_of(hit.begin(), hit.end(), [this](std::size_t candidate) {
    return knowledge[candidate] == Knowledge::NotWanted;
  });
}

std::size_t Situation::openMembers(const Conflict& conflict) const {
  const auto members = achievability::members(conflict.members);
  return static_cast<std::size_t>(std::count_if(
      members.begin(), members.end(),
      [this](std::size_t candidate) { return knowledge[candidate] == Knowledge::Open; }));
}

std::optional<std::size_t> smallestLiveConflict(const Situation& situation, std::size_t candidate) {
  std::optional<std::size_t> best;
  const auto key = [&](std::size_t i) {
    const Conflict& conflict = situation.conflicts[i];
    return std::make_tuple(!conflict.proven, situation.openMembers(conflict));
  };
  for (std::size_t i = 0; i < situation.conflicts.size(); ++i) {
    const Conflict& conflict = situation.conflicts[i];
    if (!conflict.members.test(candidate) || !situation.isLive(conflict)) continue;
    if (!best || key(i) < key(*best)) best = i;
  }
  return best;
}

}  // namespace goal_alignment::questions
