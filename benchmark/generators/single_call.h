// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/search/result.h"

namespace goal_alignment::benchmarks {

enum class CallKind : std::uint8_t {
  First,    ///< any plan, unit costs
  Optimal,  ///< the cheapest by the task's own metric
};

/// What one planning call took, phase by phase, and what came of it.
struct SingleCall {
  std::size_t objects = 0;
  std::size_t facts = 0;      ///< that change
  std::size_t operators = 0;  ///< relaxed reachable
  double parse = 0;           ///< seconds, as all times here
  double ground = 0;
  double mutexes = 0;  ///< h² table
  double search = 0;   ///< with the successor generator
  search::Result result;
  std::vector<GroundName> plan;  ///< validated
};

/// From two texts to a plan, a proof, or a limit. The one place of the measurements that knows how
/// the planner's parts fit together. Throws what reading throws, and Exception where a plan does
/// not pass validation.
SingleCall singleCall(const pddl::Source& domain, const pddl::Source& problem, CallKind kind,
                      const Limits& limits);

/// The relaxed reachable operators of a task: how large it really is.
std::size_t operatorCount(const pddl::Source& domain, const pddl::Source& problem);

}  // namespace goal_alignment::benchmarks
