// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/anytime.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/task/task.h"
#include "goal_set_task.h"

namespace goal_alignment::achievability {

/// Every search on the robot's task, counted. What the searches find is not remembered here.
class Planner {
 public:
  /// The task must outlive this. `threads`: how many greedyForEach() uses.
  Planner(const GoalSetTask& task, int threads) : task_(task), threads_(threads) {}

  search::Result greedy(const task::Goal& goal, const Limits& limits);
  /// Greedy searches side by side, each within the limits; the results don't depend on the number
  /// of threads.
  std::vector<search::Result> greedyForEach(const std::vector<task::Goal>& goals,
                                            const Limits& limits);
  /// A proof from a part of the task: see searchInParts().
  search::Result inParts(const CandidateSet& set, const Limits& limits);
  /// A plan that no plan undercuts in cost.
  search::Result optimal(const CandidateSet& set, const Limits& limits);
  /// The plan made cheaper as long as the limits let.
  search::Improved improve(const CandidateSet& set, const task::Plan& plan, const Limits& limits);

  /// Counts a search that somebody else makes: a sweep through the reachable states.
  void countSweep() { ++calls_; }
  std::size_t calls() const { return calls_; }

 private:
  const GoalSetTask& task_;
  int threads_;
  std::size_t calls_ = 0;
};

}  // namespace goal_alignment::achievability
