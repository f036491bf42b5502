// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::search {

/// Sets of facts that no reachable state has together with a goal, while it has every proper
/// subset.
struct MinimalConflicts {
  std::vector<task::FactSet> sets;
  bool all = false;                       ///< there are no others
  LimitReason limit = LimitReason::None;  ///< why there may be others; None: more than were wanted
};

/// Symbolic search: the set of all reachable states as one decision diagram, computed once, from
/// which every goal set is answered at once. It needs no goal and counts well: where lifts fill up,
/// fuel runs out or pigeons want holes, the states are many and the diagram is small.
///
///     Symbolic symbolic(task, groups);
///     if (symbolic.run(limits) == LimitReason::None) {
///       symbolic.reachable(goal);                             // exact; false is a proof
///       symbolic.minimalConflicts(goal, candidates, 1000, limits);
///     }
class Symbolic {
 public:
  /// The task and the groups must outlive this.
  Symbolic(const task::Task& task, const heuristics::MutexGroups& groups);
  ~Symbolic();

  /// Computes the reachable states. None: done, now or before. After a limit nothing is known; it
  /// may be tried again. `limits.states` counts steps on diagrams, `limits.bytes` is held by them
  /// until the end of this object.
  LimitReason run(const Limits& limits);
  bool complete() const;

  /// Whether some reachable state satisfies the goal. Only once complete. O(nodes).
  bool reachable(const task::Goal& goal) const;

  /// A plan, not a shortest one; nothing where the goal is unreachable or the limits are too
  /// narrow. Only once complete.
  std::optional<task::Plan> plan(const task::Goal& goal, const Limits& limits);

  /// All minimal sets of `candidates` that can't be had together with the goal, at most `most` of
  /// them; the empty set where the goal itself can't be had. Only once complete. Computed on
  /// diagrams without listing what can be had; its limits are counted apart from those of run().
  MinimalConflicts minimalConflicts(const task::Goal& goal, const task::FactSet& candidates,
                                    std::size_t most, const Limits& limits) const;

  /// How many states are reachable, as far as a double tells, and how many nodes say so.
  double stateCount() const;
  std::size_t nodeCount() const;
  std::size_t bytes() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace goal_alignment::search
