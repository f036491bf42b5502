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
class MutexTable {
 public:
  /// Fixpoint over bitset rows: O(passes · operators · facts · |effect| / 64), n² bits of memory.
  /// Throws LimitReached.
  MutexTable(const task::Task& task, const Limits& limits);

  /// Whether the two facts are never true together; with f == g: whether f is never true.
  bool mutex(task::FactId f, task::FactId g) const { return !task::testBit(row(f), g); }

  /// Whether the set contains a mutex pair or an unreachable fact; if so `pair` gets it.
  bool contains(const task::FactSet& facts, task::FactSet* pair = nullptr) const;

  /// The task without the operators whose precondition contains a mutex: they can never be applied.
  task::Task withoutInapplicable(task::Task task) const;

 private:
  const task::Word* row(task::FactId fact) const { return together_.data() + fact * words_; }
  task::Word* row(task::FactId fact) { return together_.data() + fact * words_; }
  void possibleAfter(const task::Operator& op, std::vector<task::Word>& after) const;
  bool reachTogether(task::FactId f, const std::vector<task::Word>& others);

  std::size_t fact_count_;
  std::size_t words_;
  std::vector<task::Word> together_;  // row f, bit g: f and g may be true together
  std::vector<bool> applicable_;
};

}  // namespace goal_alignment::heuristics
