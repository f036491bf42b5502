// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <tuple>
#include <utility>

#include "goal_alignment/questions/policy.h"
#include "live_conflict.h"

namespace goal_alignment::questions {

using achievability::Conflict;

bool Situation::isLive(const Conflict& conflict) const {
  const auto& members = conflict.members;
  for (std::size_t f = members.find_first(); f != members.npos; f = members.find_next(f)) {
    if (knowledge[f] == Knowledge::NotWanted) return false;
  }
  return true;
}

std::size_t Situation::openMembers(const Conflict& conflict) const {
  const auto& members = conflict.members;
  std::size_t count = 0;
  for (std::size_t f = members.find_first(); f != members.npos; f = members.find_next(f)) {
    if (knowledge[f] == Knowledge::Open) ++count;
  }
  return count;
}

achievability::CandidateSet Situation::relevantCandidates() const {
  achievability::CandidateSet result(knowledge.size());
  for (const Conflict& conflict : conflicts) {
    if (isLive(conflict)) result |= conflict.members;
  }
  for (std::size_t f = 0; f < knowledge.size(); ++f) {
    if (knowledge[f] != Knowledge::Open) result.reset(f);
  }
  return result;
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

std::vector<LiveConflict> liveConflicts(const Situation& situation) {
  std::vector<LiveConflict> live;
  for (std::size_t i = 0; i < situation.conflicts.size(); ++i) {
    if (!situation.isLive(situation.conflicts[i])) continue;
    std::vector<std::size_t> open = achievability::members(situation.conflicts[i].members);
    const auto answered = [&](std::size_t f) { return situation.knowledge[f] != Knowledge::Open; };
    open.erase(std::remove_if(open.begin(), open.end(), answered), open.end());
    if (open.empty()) return {};
    live.push_back({i, std::move(open)});
  }
  return live;
}

Choice chooseAmong(const std::vector<std::size_t>& candidates, const Situation& situation,
                   RandomSource& random) {
  std::vector<Choice> choices;
  bool proven = false;
  for (const std::size_t f : candidates) {
    const Choice choice = {f, smallestLiveConflict(situation, f)};
    const bool this_proven = choice.conflict && situation.conflicts[*choice.conflict].proven;
    if (proven && !this_proven) continue;
    if (this_proven && !proven) choices.clear();
    proven = this_proven;
    choices.push_back(choice);
  }
  return choices[random.below(choices.size())];
}

}  // namespace goal_alignment::questions
