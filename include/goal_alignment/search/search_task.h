// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/search/state_packing.h"
#include "goal_alignment/search/successor_generator.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// A task made ready for searching, once for all goals and threads: how to find what a state can
/// apply, and how states are written down.
class SearchTask {
 public:
  /// Throws LimitReached.
  SearchTask(task::Task task, heuristics::MutexGroups groups, const Limits& limits = {});

  /// Every fact is a group of its own.
  explicit SearchTask(task::Task task);

  SearchTask(const SearchTask&) = delete;
  SearchTask& operator=(const SearchTask&) = delete;

  const task::Task& task() const { return task_; }
  const heuristics::MutexGroups& groups() const { return groups_; }
  const SuccessorGenerator& successors() const { return successors_; }
  const StatePacking& packing() const { return packing_; }

 private:
  task::Task task_;
  heuristics::MutexGroups groups_;
  SuccessorGenerator successors_;
  StatePacking packing_;
};

}  // namespace goal_alignment::search
