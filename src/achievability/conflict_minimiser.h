// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_set>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/achievability/search_budget.h"
#include "goal_alignment/common/limits.h"
#include "goal_set_knowledge.h"
#include "goal_set_task.h"
#include "planner.h"
#include "reachable_states.h"

namespace goal_alignment::achievability {

/// The way from a set proven unachievable to a minimal conflict.
class ConflictMinimiser {
 public:
  /// All of them must outlive this.
  ConflictMinimiser(const GoalSetTask& task, GoalSetKnowledge& knowledge, Planner& planner,
                    const ReachableStates& reachable, const SearchBudget& budget)
      : task_(task),
        knowledge_(knowledge),
        planner_(planner),
        reachable_(reachable),
        budget_(budget) {}

  /// Shrinks a set proven unachievable to a conflict and learns that.
  void learnUnachievable(const CandidateSet& set, const Limits& limits);

  /// A proven conflict within the set, or null, without the members that it can do without as far
  /// as a short search tells. The pointer is into the knowledge and valid until that learns more.
  const Conflict* smallConflictWithin(CandidateSet set, const Limits& limits);

 private:
  bool provenUnachievable(const CandidateSet& set, std::uint64_t& states, const Limits& limits);
  void learnTested(const CandidateSet& conflict, const Limits& limits);
  bool replaceBySmaller(const CandidateSet& conflict, const Limits& limits);

  const GoalSetTask& task_;
  GoalSetKnowledge& knowledge_;
  Planner& planner_;
  const ReachableStates& reachable_;
  const SearchBudget& budget_;
  std::unordered_set<CandidateSet> tested_;  // conflicts tested without each of their members
};

}  // namespace goal_alignment::achievability
