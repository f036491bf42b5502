// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/task/state.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::heuristics {

/// Pairs of facts that no state reachable from the initial state makes true together: the pairs
/// that h² finds unreachable (Haslum & Geffner, "Admissible Heuristics for Optimal Planning", AIPS
/// 2000). What it calls mutex is proven; what it doesn't may be mutex all the same.
///
/// An operator with conditional effects is looked at once for each of them. An effect is taken to
/// happen where its condition may be true, and its deletes only where the condition must be.
class MutexTable {
 public:
  /// Fixpoint over bitset rows: O(passes · operators · facts · |effect| / 64), n² bits of memory.
  /// A table that would be too large (a quarter of the limit in bytes, 64 MiB at most), or would
  /// take too many steps, knows of no mutex at all. Throws LimitReached on a cancel, at the
  /// deadline and at the limit of states, of which it generates none.
  MutexTable(const task::Task& task, const Limits& limits);

  /// Whether the table knows anything.
  bool known() const { return !together_.empty(); }

  /// Whether the two facts are never true together; with f == g: whether f is never true.
  bool mutex(task::FactId f, task::FactId g) const { return known() && !task::testBit(row(f), g); }

  /// Whether the set contains a mutex pair or an unreachable fact; if so `pair` gets it.
  bool contains(const task::FactSet& facts, task::FactSet* pair = nullptr) const;

  /// Whether every alternative of the goal contains one.
  bool rulesOut(const task::Goal& goal) const;

  /// Whether the operator's precondition is free of mutexes.
  bool applicable(task::OperatorId op) const { return applicable_[op]; }

  /// The task without the operators whose precondition contains a mutex: they can never be applied.
  task::Task withoutInapplicable(task::Task task) const;

 private:
  class Fixpoint;

  const task::Word* row(task::FactId fact) const { return together_.data() + fact * words_; }
  task::Word* row(task::FactId fact) { return together_.data() + fact * words_; }
  bool reachTogether(task::FactId f, const std::vector<task::Word>& others);

  std::size_t fact_count_;
  std::size_t words_;
  std::vector<task::Word> together_;  // row f, bit g: f and g may be true together; none: not known
  std::vector<bool> applicable_;
};

}  // namespace goal_alignment::heuristics
