// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// A plan and what is known of its cost.
struct Improved {
  task::Plan plan;
  task::Cost cost = 0;
  bool optimal = false;                   ///< proven
  LimitReason limit = LimitReason::None;  ///< why it went no further, where it is not proven
};

/// Improves a plan until it is proven optimal or the limits end it: restarting weighted A*
/// (Richter, Thayer & Ruml, "The Joy of Forgetting: Faster Anytime Search via Restarting", ICAPS
/// 2010) with falling weights, each looking for cheaper plans only; then A*, which proves. The
/// limits' states and bytes hold for each of these searches.
Improved improve(const SearchTask& task, const task::Goal& goal, task::Plan plan,
                 const Limits& limits);

}  // namespace goal_alignment::search
