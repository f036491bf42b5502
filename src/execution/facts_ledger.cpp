// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/facts_ledger.h"

#include <ros/console.h>

#include <algorithm>
#include <iterator>

namespace goal_alignment::execution {

void FactsLedger::beginRun() {
  for (auto entry = entries_.begin(); entry != entries_.end();)
    entry = entry->second.told ? entries_.erase(entry) : std::next(entry);
}

void FactsLedger::enter(const std::vector<Literal>& changes) {
  for (const Literal& change : changes)
    entries_[change.atom] = {!change.negated, false};
  tell();
}

bool FactsLedger::waits() const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [](const auto& entry) { return !entry.second.told; });
}

void FactsLedger::noticeRestart(const std::string& life) {
  const bool was_told = std::any_of(entries_.begin(), entries_.end(),
                                    [](const auto& entry) { return entry.second.told; });
  if (life.empty() || life_.empty() || life == life_ || !was_told) return;
  ROS_WARN("the aligner was started anew: it is told again what the steps have changed");
  for (auto& entry : entries_)
    entry.second.told = false;
}

void FactsLedger::tellAgain() {
  for (auto& entry : entries_)
    entry.second.told = false;
  tell();
}

bool FactsLedger::tell() {
  if (entries_.empty()) return true;
  const std::string life = aligner_.life();
  noticeRestart(life);
  std::vector<Literal> changes;
  for (const auto& [atom, entry] : entries_) {
    if (!entry.told) changes.push_back({atom, !entry.holds});
  }
  const bool taken = changes.empty() || (!life.empty() && aligner_.tell(changes));
  if (!taken) {
    if (!is_lamented_)
      ROS_WARN("the aligner does not take what the steps have changed; it is told once it does");
    is_lamented_ = true;
    return false;
  }
  if (is_lamented_) ROS_INFO("the aligner knows by now what the steps have changed");
  is_lamented_ = false;
  for (auto& entry : entries_)
    entry.second.told = true;
  // One that is started anew in between has another life, and is told at the next look.
  if (!life.empty()) life_ = life;
  return true;
}

void FactsLedger::compare(const WorldState& world) {
  if (entries_.empty() || aligner_.life() != life_) return;
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    const auto& [atom, claim] = *entry;
    const bool is_unknown =
        std::find(world.unknown.begin(), world.unknown.end(), atom) != world.unknown.end();
    const bool holds = std::binary_search(world.facts.begin(), world.facts.end(), atom);
    const bool is_past = claim.told && (is_unknown || holds != claim.holds);
    entry = is_past ? entries_.erase(entry) : std::next(entry);
  }
}

}  // namespace goal_alignment::execution
