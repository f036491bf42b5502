// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/achievability/search_budget.h"
#include "goal_alignment/common/limits.h"
#include "goal_set_knowledge.h"
#include "goal_set_prover.h"
#include "goal_set_task.h"
#include "planner.h"
#include "reachable_states.h"

namespace goal_alignment::achievability {

/// Stage 4: the enumeration of all minimal conflicts by MARCO (see SubsetMap): takes a maximal
/// unexplored set, checks it, and learns that it is achieved or contains a conflict, until no set
/// is unexplored. Where the reachable states are at hand as a diagram, that lists them instead.
class ConflictEnumeration {
 public:
  /// All of them must outlive this.
  ConflictEnumeration(const GoalSetTask& task, GoalSetKnowledge& knowledge, Planner& planner,
                      const ReachableStates& reachable, GoalSetProver& prover,
                      const SearchBudget& budget)
      : task_(task),
        knowledge_(knowledge),
        planner_(planner),
        reachable_(reachable),
        prover_(prover),
        budget_(budget) {}

  /// Goes on from what is known; whether all is known afterwards the knowledge says. Returns the
  /// last limit that ended a check or the whole, or None.
  LimitReason run(const Limits& limits);

 private:
  bool explore(const Limits& limits, LimitReason& last_limit);
  bool listFromDiagram(const Limits& limits);
  bool planForEach(const std::vector<CandidateSet>& sets, const Limits& limits);

  const GoalSetTask& task_;
  GoalSetKnowledge& knowledge_;
  Planner& planner_;
  const ReachableStates& reachable_;
  GoalSetProver& prover_;
  const SearchBudget& budget_;
};

}  // namespace goal_alignment::achievability
