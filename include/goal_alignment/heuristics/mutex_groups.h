// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/mutexes.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::heuristics {

/// A partition of a task's facts into groups of which no reachable state makes two facts true: what
/// a state can be packed by, one value a group.
class MutexGroups {
 public:
  /// Where a fact stands: it is `groups()[group][value]`.
  struct Place {
    std::uint32_t group = 0;
    std::uint32_t value = 0;
  };

  /// The groups must be mutex groups and hold every fact once. Throws LimitReached.
  MutexGroups(const task::Task& task, std::vector<task::FactSet> groups, const Limits& limits = {});

  const std::vector<task::FactSet>& groups() const { return groups_; }
  Place place(task::FactId fact) const { return places_[fact]; }

  /// Every reachable state makes one fact of the group true; else there may be none.
  bool exactlyOne(std::size_t group) const { return exactly_one_[group]; }

  /// The values that a group can have: its facts, and "none of them" where that can be.
  std::uint32_t valueCount(std::size_t group) const {
    return static_cast<std::uint32_t>(groups_[group].size()) + (exactly_one_[group] ? 0U : 1U);
  }

 private:
  std::vector<task::FactSet> groups_;
  std::vector<Place> places_;
  std::vector<bool> exactly_one_;
};

/// Covers the facts with cliques of the mutex graph, the largest found first.
/// O(groups · facts² / 64) and more where cliques compete. Throws LimitReached.
MutexGroups groupsFromPairs(const task::Task& task, const MutexTable& mutexes,
                            const Limits& limits);

/// Fact-alternating mutex groups (Fišer & Komenda, "Fact-Alternating Mutex Groups for Classical
/// Planning", JAIR 2018): sets of which one fact at most is true initially, and into which no
/// operator adds more facts than it takes out of it. Grown fact by fact, each operator that is out
/// of balance being repaired by one of the facts it consumes, so that memory is linear in the task,
/// where a mutex table takes facts². Finds fewer groups than the table. Throws LimitReached.
MutexGroups groupsFromInvariants(const task::Task& task, const Limits& limits);

/// From the table where it knows anything, else from invariants. Throws LimitReached.
MutexGroups mutexGroups(const task::Task& task, const MutexTable& mutexes, const Limits& limits);

}  // namespace goal_alignment::heuristics
