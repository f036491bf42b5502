// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/heuristics/landmarks.h"
#include "goal_alignment/heuristics/priority_queue.h"
#include "goal_alignment/heuristics/relaxed_task.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::heuristics {

/// LM-cut (Helmert & Domshlak, "Landmarks, Critical Paths and Abstractions: What's the Difference
/// Anyway?", ICAPS 2009): the sum of the cheapest costs of disjunctive action landmarks found one
/// after the other as cuts in the h_max justification graph. Admissible. The parts of an operator
/// with conditional effects share one cost.
///
/// Incremental (Pommerening & Helmert, "Incremental LM-Cut", ICAPS 2013): a landmark of a state
/// that does not contain the operator applied there is one of the successor too, so that only few
/// cuts are left to be found.
///
/// One evaluation is O(landmarks · size of the relaxed task · log), far less as h_max is kept up to
/// date between cuts.
class LmCut {
 public:
  /// `cancel` may be null; one evaluation of a large task takes longer than a cancel may. Throws
  /// LimitReached.
  LmCut(const task::Task& task, const task::Goal& goal, const CancelToken* cancel = nullptr);

  /// A lower bound on the cost from the state to the goal; kInfinity: proven unreachable. Cut short
  /// by a cancel it is a lower bound still.
  task::Cost evaluate(const task::Word* state);

  /// The same for the state that `op` leads to from one that has these landmarks.
  task::Cost evaluate(const task::Word* state, const Landmarks& before, task::OperatorId op);

  /// Of the state evaluated last: their costs add up to its value, unless that is kInfinity.
  const Landmarks& landmarks() const { return landmarks_; }

 private:
  enum class Zone : std::uint8_t { None, Goal, Seen, BeforeGoal, Apart };

  struct Fact {
    task::Cost cost;  // h_max
    bool reached;
    Zone zone;  // while a cut is being found
  };
  struct Operator {
    task::Cost cost;            // what earlier landmarks left of it
    task::Cost supporter_cost;  // h_max of the supporter
    std::uint32_t supporter;    // the dearest precondition
    std::uint32_t unsatisfied;  // preconditions not reached yet
  };

  void reset();
  void inherit(const Landmarks& before, task::OperatorId op);
  task::Cost complete(const task::Word* state);
  void reach(task::FactId fact, task::Cost cost);
  void exploreAll(const task::Word* state);
  void exploreAfterCut();
  void enterGoalZone();
  void findCut();
  bool reachedBeforeZone(task::FactId fact);
  void payForCut();
  void addSiblings();
  void findSupporter(std::uint32_t op);

  const CancelToken* cancel_;
  RelaxedTask relaxed_;
  std::size_t state_words_;
  std::vector<Fact> facts_;
  std::vector<Operator> operators_;
  std::vector<Operator> fresh_operators_;
  std::vector<task::FactId> goal_zone_;
  std::vector<std::uint32_t> crossing_;  // operators that add a fact of the goal zone from outside
  std::vector<std::uint8_t> marked_;     // the same by operator, then the cut's siblings
  std::vector<std::uint32_t> cut_;
  std::vector<task::FactId> seen_;
  std::vector<task::FactId> settled_;  // facts in the zones BeforeGoal and Apart
  std::vector<task::OperatorId> cut_origins_;
  PriorityQueue queue_;
  Landmarks landmarks_;
};

}  // namespace goal_alignment::heuristics
