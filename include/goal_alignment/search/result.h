// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// The three values of every search: running out proves nothing.
enum class Status : std::uint8_t { Solved, Unsolvable, LimitReached };

struct Statistics {
  std::uint64_t expanded = 0;
  std::uint64_t evaluated = 0;
  std::uint64_t generated = 0;
  std::size_t bytes = 0;  ///< accounted, at the end
  double preparing = 0;   ///< seconds that mutexes and the like took before, of solve()
};

struct Result {
  Status status = Status::LimitReached;
  LimitReason limit = LimitReason::None;  ///< with LimitReached
  task::Plan plan;                        ///< with Solved
  task::Cost cost = 0;                    ///< of the plan
  Statistics statistics;
};

/// What the search returns; where a limit ends it before it has begun, a result that says so.
template <typename Search>
Result resultOf(Search&& search) {
  try {
    return search();
  } catch (const LimitReached& stopped) {
    Result result;
    result.limit = stopped.reason();
    result.statistics.generated = 1;  // the initial state, which every search counts
    return result;
  }
}

}  // namespace goal_alignment::search
