// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// What an operator does to the value of one group: which value may become which. Values that are
/// in no pair block it.
struct LocalChange {
  std::uint32_t group = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // from, to

  bool changes() const;
};

/// An operator, or one case of an operator with conditional effects, as a product of local changes:
/// groups that are not named stay as they are.
struct Event {
  task::OperatorId op = 0;
  std::vector<LocalChange> changes;  // by rising group
};

/// The task's operators as events; those that change nothing, or that no reachable state allows,
/// are left out. Conditional effects split an operator into the cases of which of them come about:
/// as many as 2^effects where nothing rules any out. Throws LimitReached, of states where there are
/// more than 50 000 such cases.
std::vector<Event> makeEvents(const task::Task& task, const heuristics::MutexGroups& groups,
                              const Limits& limits);

}  // namespace goal_alignment::search
