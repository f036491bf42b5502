// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "conflict_minimiser.h"
#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/achievability/check.h"
#include "goal_alignment/achievability/search_budget.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/search/result.h"
#include "goal_set_knowledge.h"
#include "goal_set_task.h"
#include "planner.h"
#include "reachable_states.h"

namespace goal_alignment::achievability {

/// Proves what is not known yet: whether a set of candidates can be had together with the
/// specified goal. The stages stand in prove(), in their order and each with its budget.
class GoalSetProver {
 public:
  /// All of them must outlive this.
  GoalSetProver(const GoalSetTask& task, GoalSetKnowledge& knowledge, Planner& planner,
                ReachableStates& reachable, ConflictMinimiser& minimiser,
                const SearchBudget& budget)
      : task_(task),
        knowledge_(knowledge),
        planner_(planner),
        reachable_(reachable),
        minimiser_(minimiser),
        budget_(budget) {}

  /// From memory where that suffices, else through the stages. Where our own budgets leave the set
  /// undecided, a suspected conflict within it is known afterwards, as small as was cheap to find.
  /// What the searches find on the way is learnt whatever the verdict.
  Check check(const CandidateSet& set, const Limits& limits);

 private:
  /// What the stages know of each other.
  struct Attempt {
    const CandidateSet& set;
    const Limits& limits;
    bool sweep_is_due;
    LimitReason limit = LimitReason::None;  ///< what ended the last stage
  };

  Check prove(const CandidateSet& set, const Limits& limits);
  std::optional<Check> searchBeforeSweep(Attempt& attempt);
  std::optional<Check> sweep(Attempt& attempt);
  std::optional<Check> lookUp(Attempt& attempt);
  std::optional<Check> searchAfterSweep(Attempt& attempt);

  std::optional<Check> searchGreedily(const CandidateSet& set, const Limits& limits,
                                      LimitReason& limit);
  std::optional<Check> learnFrom(const CandidateSet& set, const search::Result& result,
                                 const Limits& limits);

  Check refineUnknown(const CandidateSet& set, Check last, const Limits& limits);
  bool remainsUndecided(const CandidateSet& set, const Limits& limits);
  bool settle(const CandidateSet& undecided, const CandidateSet& whole, const Limits& limits);

  const GoalSetTask& task_;
  GoalSetKnowledge& knowledge_;
  Planner& planner_;
  ReachableStates& reachable_;
  ConflictMinimiser& minimiser_;
  const SearchBudget& budget_;
};

}  // namespace goal_alignment::achievability
