// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "goal_alignment/achievability/achieved_sets.h"
#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/achievability/check.h"
#include "goal_alignment/achievability/search_budget.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/search/anytime.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/task/task.h"

/// One robot task, many goal sets: which candidates can be had together with the specified goal?
namespace goal_alignment::achievability {

/// The façade: what is known of the goal sets of one task, and ways to find out more. Remembers
/// every set achieved and every conflict, so that what they imply needs no search. Unless said
/// otherwise a function that reaches a limit says so in what it returns and throws nothing.
class Achievability {
 public:
  /// Classifies the candidates and finds the conflicts of stages 1 (relaxed reachability, unknown
  /// names) and 2 (h² mutexes). `robot` must have been grounded with `specified` and `candidates`.
  /// Throws LimitReached.
  Achievability(grounding::GroundTask robot, const std::vector<Literal>& specified,
                const std::vector<Literal>& candidates, const SearchBudget& budget,
                const Limits& limits);
  ~Achievability();

  /// Stage 0: a sequence of ground actions known to run; every state along it that satisfies the
  /// specified goal is an achieved set. Throws LimitReached.
  void recordExecution(const std::vector<GroundName>& actions, const Limits& limits = {});

  /// Can all of `set` be had together with the specified goal? Answers from memory where it can,
  /// else searches: greedily, then through all reachable states (stage 3, usually only once), one
  /// by one or symbolically; where that did not come to its end greedily again. Where our own
  /// budgets leave the set undecided, a suspected conflict within it is known afterwards, as small
  /// as was cheap to find.
  Check check(const CandidateSet& set, const Limits& limits);

  /// Which candidates can be had at all, without the specified goal? Those that can't are the
  /// paper's F̂.
  std::vector<Verdict> reachableAlone(const Limits& limits);
  /// What is known of one candidate without a search.
  std::optional<Verdict> recallAlone(std::size_t candidate) const;

  /// A plan for the set that no plan undercuts in cost; LimitReached where the limits end the
  /// search.
  search::Result optimalPlan(const CandidateSet& set, const Limits& limits);

  /// A plan for the set made cheaper for as long as the limits allow.
  search::Improved improvedPlan(const CandidateSet& set, const task::Plan& plan,
                                const Limits& limits);

  /// Finds all minimal conflicts (stage 4: MARCO; Liffiton, Previti, Malik & Marques-Silva, "Fast,
  /// flexible MUS enumeration", Constraints 2016). True: complete. Anytime: what was found before a
  /// limit stays, and the next call resumes from there. Where none ended it, every set without a
  /// plan contains a conflict, be it a suspected one. Needs at least as many searches as there are
  /// conflicts and maximal achievable sets: exponential in the worst case.
  bool findAllConflicts(const Limits& limits);

  /// Of all that is wanted, what to give up so that a plan for the rest is known and giving up less
  /// would not do, as far as the checks tell. `belief` is p(f ∈ G*) by candidate. Returns at most
  /// `max_alternatives` sets, by falling Π (1 − belief) over what is given up; none where the
  /// specified goal alone can't be had, and fewer where the limits end it. Best first through the
  /// hitting sets of the conflicts within what is wanted, which checks find on the way (Reiter, "A
  /// theory of diagnosis from first principles", Artificial Intelligence 1987); where those are too
  /// many to go through, the remaining sets are good, not best.
  std::vector<CandidateSet> alternatives(const CandidateSet& wanted,
                                         const std::vector<double>& belief,
                                         std::size_t max_alternatives, const Limits& limits);

  /// Whether all minimal conflicts are known, each proven. True at once where everything can be
  /// had.
  bool complete() const;

  /// Why the last check() or reachableAlone() that ended Unknown did so, or why findAllConflicts()
  /// did not come to its end.
  LimitReason lastLimit() const { return last_limit_; }

  /// Records that the limits left the set undecided.
  void suspect(const CandidateSet& set);

  /// None is a superset of a proven other. References into them end when more is found out.
  const std::vector<Conflict>& conflicts() const;
  /// A proven conflict within the set, or null.
  const Conflict* provenConflictWithin(const CandidateSet& set) const;
  /// The same without the members that it can do without as far as a short search tells, and marked
  /// minimal where the search shows it. The search may find and replace other conflicts, too.
  const Conflict* smallConflictWithin(const CandidateSet& set, const Limits& limits);
  /// The maximal sets known to be achieved, each with a plan.
  const std::vector<AchievedSets::Achieved>& achieved() const;

  /// The candidates that hold in every state the robot can reach: nobody needs to ask about them.
  const CandidateSet& alwaysTrue() const;

  const task::Task& task() const;
  std::size_t candidateCount() const;
  /// How many searches were made so far, sweeps through the reachable states included.
  std::size_t plannerCalls() const;

 private:
  struct Parts;

  std::unique_ptr<Parts> parts_;
  LimitReason last_limit_ = LimitReason::None;
};

}  // namespace goal_alignment::achievability
