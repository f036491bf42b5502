// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "conflict_set.h"
#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/heuristics/mutexes.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::achievability {

/// The robot's task as goal sets see it: which fact each candidate is, the goal that a set of
/// candidates makes, and what follows from grounding and mutexes without any search. Constant.
class GoalSetTask {
 public:
  /// `robot` must have been grounded with `specified` and `candidates`. Finds the conflicts of
  /// stages 1 (relaxed reachability, unknown names) and 2 (h² mutexes). Throws LimitReached.
  GoalSetTask(grounding::GroundTask robot, const std::vector<Literal>& specified,
              const std::vector<Literal>& candidates, const Limits& limits);

  /// Without the operators that mutexes rule out.
  const search::SearchTask& searchTask() const { return *search_task_; }
  const task::Task& task() const { return search_task_->task(); }
  const heuristics::MutexTable& mutexes() const { return *mutexes_; }

  std::size_t candidateCount() const { return facts_.size(); }
  /// The specified goal, without what is always true.
  const task::Goal& specified() const { return specified_; }
  /// The candidates that hold in every reachable state.
  const CandidateSet& alwaysTrue() const { return always_true_; }
  /// Candidates that hold in no reachable state, as far as grounding and mutexes tell.
  const CandidateSet& neverTrue() const { return never_true_; }
  /// The conflicts of stages 1 and 2, all proven.
  const ConflictSet& conflicts() const { return conflicts_; }

  /// Nothing where grounding has shown the candidate to be always or never true.
  std::optional<task::FactId> factOf(std::size_t candidate) const;
  /// The facts of the candidates in the set that have one, in the order of the candidates.
  task::FactSet factsOf(const CandidateSet& set) const;
  /// The specified goal together with the set.
  task::Goal goalWith(const CandidateSet& set) const;
  /// The candidates that hold in the state.
  CandidateSet satisfiedBy(const task::Word* state) const;

 private:
  static constexpr task::FactId kNoFact = static_cast<task::FactId>(-1);

  void classify(const grounding::GroundTask& robot, const std::vector<Literal>& specified,
                const std::vector<Literal>& candidates, LimitMonitor& monitor);
  void findMutexConflicts(LimitMonitor& monitor);
  void addMutexPairs(const std::vector<std::size_t>& open,
                     const std::vector<CandidateSet>& possible, LimitMonitor& monitor);
  void addConflict(const std::vector<std::size_t>& candidates);

  std::vector<task::FactId> facts_;  // by candidate; kNoFact: always or never true
  CandidateSet always_true_;
  CandidateSet never_true_;
  ConflictSet conflicts_;
  task::Goal specified_;
  std::optional<heuristics::MutexTable> mutexes_;
  std::optional<search::SearchTask> search_task_;
};

}  // namespace goal_alignment::achievability
