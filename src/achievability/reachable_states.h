// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/achievability/search_budget.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/symbolic.h"
#include "goal_alignment/task/task.h"
#include "goal_set_knowledge.h"
#include "goal_set_task.h"
#include "planner.h"

namespace goal_alignment::achievability {

/// Stage 3: all reachable states, swept once, after which every check is answered without a
/// search. A sweep ends in one of two forms, or in none where the budgets do not suffice:
/// enumerated, so that the knowledge has every achieved set, or as a decision diagram.
class ReachableStates {
 public:
  /// All four must outlive this.
  ReachableStates(const GoalSetTask& task, GoalSetKnowledge& knowledge, Planner& planner,
                  const SearchBudget& budget)
      : task_(task), knowledge_(knowledge), planner_(planner), budget_(budget) {}

  /// Whether a sweep is worth its time: none was made yet, or the time ended it and there is much
  /// more of it now.
  bool sweepIsDue(const Limits& limits) const;
  /// Sweeps within half of the time left. None: it came to its end.
  LimitReason sweep(const Limits& limits);
  /// What ended the last sweep.
  LimitReason sweepLimit() const { return sweep_limit_; }

  /// All were visited one by one: what the knowledge does not say to be achieved is unachievable.
  bool enumerated() const { return enumerated_; }
  /// They are at hand as a decision diagram; only then may the functions below be called.
  bool haveDiagram() const { return diagram_ != nullptr; }

  bool satisfy(const task::Goal& goal) const { return diagram_->reachable(goal); }
  /// A plan, not a shortest one; nothing where the goal is unreachable or the limits end it.
  std::optional<task::Plan> planFor(const task::Goal& goal, const Limits& limits) const {
    return diagram_->plan(goal, limits);
  }
  /// All minimal conflicts; nothing where they are too many or the limits end it.
  std::optional<std::vector<CandidateSet>> minimalConflicts(const Limits& limits) const;

 private:
  LimitReason makeDiagram(std::uint64_t steps, const Limits& limits);
  LimitReason enumerate(std::uint64_t states, const Limits& limits);

  const GoalSetTask& task_;
  GoalSetKnowledge& knowledge_;
  Planner& planner_;
  const SearchBudget& budget_;
  std::unique_ptr<search::Symbolic> diagram_;
  bool enumerated_ = false;
  bool swept_ = false;  // as far as the budgets reach
  // How much time must be left to sweep once more.
  Limits::Clock::duration worthwhile_time_ = Limits::Clock::duration::max();
  LimitReason sweep_limit_ = LimitReason::None;
};

}  // namespace goal_alignment::achievability
