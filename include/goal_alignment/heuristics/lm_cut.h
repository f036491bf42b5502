// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/priority_queue.h"
#include "goal_alignment/heuristics/relaxed_task.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::heuristics {

/// LM-cut (Helmert & Domshlak, "Landmarks, Critical Paths and Abstractions: What's the Difference
/// Anyway?", ICAPS 2009): the sum of the cheapest costs of disjunctive action landmarks found one
/// after the other as cuts in the h_max justification graph. Admissible.
///
/// One evaluation is O(landmarks · size of the relaxed task · log), far less as h_max is kept up to
/// date between cuts.
class LmCut {
 public:
  /// `cancel` may be null; one evaluation of a large task takes longer than a cancel may.
  LmCut(const task::Task& task, const task::FactSet& goal, const CancelToken* cancel = nullptr);

  /// A lower bound on the cost from the state to the goal; kInfinity: proven unreachable. Cut short
  /// by a cancel it is a lower bound still.
  task::Cost evaluate(const task::Word* state);

 private:
  struct Fact {
    task::Cost cost;  // h_max
    bool reached;
    std::uint8_t zone;  // while a cut is being found
  };
  struct Operator {
    task::Cost cost;            // what earlier landmarks left of it
    task::Cost supporter_cost;  // h_max of the supporter
    std::uint32_t supporter;    // the dearest precondition
    std::uint32_t unsatisfied;  // preconditions not reached yet
  };

  void reset();
  void reach(task::FactId fact, task::Cost cost);
  void exploreAll(const task::Word* state);
  void exploreAfterCut();
  void enterGoalZone();
  void findCut();
  bool reachedBeforeZone(task::FactId fact);
  void findSupporter(std::uint32_t op);

  const CancelToken* cancel_;
  RelaxedTask relaxed_;
  std::size_t state_words_;
  std::vector<Fact> facts_;
  std::vector<Operator> operators_;
  std::vector<Operator> fresh_operators_;
  std::vector<task::FactId> goal_zone_;
  std::vector<std::uint32_t> crossing_;  // operators that add a fact of the goal zone from outside
  std::vector<std::uint8_t> crosses_;    // the same by operator
  std::vector<std::uint32_t> cut_;
  std::vector<task::FactId> seen_;
  PriorityQueue queue_;
};

}  // namespace goal_alignment::heuristics
