// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "goal_alignment/achievability/check.h"
#include "goal_alignment/achievability/search_budget.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/result.h"
#include "goal_set_knowledge.h"
#include "goal_set_task.h"
#include "planner.h"
#include "reachable_states.h"

namespace goal_alignment::achievability {

/// Which candidates can be had at all, each by itself and without the specified goal.
class CandidatesAlone {
 public:
  /// All of them must outlive this.
  CandidatesAlone(const GoalSetTask& task, GoalSetKnowledge& knowledge, Planner& planner,
                  const ReachableStates& reachable, const SearchBudget& budget)
      : task_(task),
        knowledge_(knowledge),
        planner_(planner),
        reachable_(reachable),
        budget_(budget) {}

  /// Without a search; nothing where that does not suffice.
  std::optional<Verdict> recall(std::size_t candidate) const;

  /// By candidate, without plans. Searches for those that nothing is known of, a batch at a time.
  std::vector<Check> checkAll(const Limits& limits);

 private:
  Check learnFrom(std::size_t candidate, const search::Result& result);

  const GoalSetTask& task_;
  GoalSetKnowledge& knowledge_;
  Planner& planner_;
  const ReachableStates& reachable_;
  const SearchBudget& budget_;
};

}  // namespace goal_alignment::achievability
