// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/search_space.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// Visits the reachable states breadth first.
class Exhaustive {
 public:
  explicit Exhaustive(const SearchTask& task);

  /// Called once for every reachable state; false ends the search.
  using Visit = std::function<bool(StateId id, const task::Word* state)>;

  /// None: every reachable state was visited, or `visit` ended the search.
  LimitReason run(const Limits& limits, const Visit& visit);

  task::Plan plan(StateId id) const { return space_.plan(id); }
  std::size_t size() const { return space_.size(); }
  std::size_t bytes() const { return space_.bytes(); }

 private:
  const SearchTask& task_;
  SearchSpace space_;
};

}  // namespace goal_alignment::search
