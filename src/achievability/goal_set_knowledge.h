// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "conflict_set.h"
#include "goal_alignment/achievability/achieved_sets.h"
#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/achievability/check.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/task/task.h"
#include "goal_set_task.h"
#include "subset_map.h"

namespace goal_alignment::achievability {

/// What is known of the goal sets of one task, however it was found out: the sets achieved, the
/// conflicts, and the candidates that hold in some reachable state or in none. Searches nothing.
class GoalSetKnowledge {
 public:
  using Achieved = AchievedSets::Achieved;

  /// Begins with what the task knows without a search. The task must outlive this.
  explicit GoalSetKnowledge(const GoalSetTask& task);

  /// Whether the set can be had, where what is known implies it.
  std::optional<Check> recall(const CandidateSet& set) const;
  /// Whether the candidate can be had without the specified goal, where that is known.
  std::optional<Verdict> recallAlone(std::size_t candidate) const;

  const std::vector<Conflict>& conflicts() const { return conflicts_.all(); }
  /// A proven conflict within the set, or null.
  const Conflict* provenConflictWithin(const CandidateSet& set) const {
    return conflicts_.provenWithin(set);
  }
  const std::vector<Achieved>& achieved() const { return achieved_.all(); }
  bool hasPlanFor(const CandidateSet& set) const { return achieved_.covering(set) != nullptr; }
  /// Whether all minimal conflicts are known and proven.
  bool complete() const { return complete_; }
  /// Whether each candidate was seen true in some reachable state.
  bool allReached() const { return reached_.all(); }

  /// At most `max_sets` maximal sets that are neither known to be achieved nor contain a conflict,
  /// proven or suspected.
  SubsetMap::Unexplored unexplored(std::size_t max_sets, const Limits& limits);

  /// Every state along the plan is reachable, and those that satisfy the specified goal are
  /// achieved sets.
  void learnPlan(const task::Plan& plan);
  void learnConflict(const Conflict& conflict);
  /// Records that the limits left the set undecided.
  void suspect(const CandidateSet& set);
  /// Records the candidates that hold in a reachable state.
  void learnReached(const CandidateSet& candidates) { reached_ |= candidates; }
  void learnNeverTrue(std::size_t candidate) { never_true_.set(candidate); }
  /// Many achieved sets at once, none of which is within another.
  void learnAchieved(std::vector<Achieved> maximal);
  /// All minimal conflicts, which takes the place of every suspicion.
  void learnAllConflicts(const std::vector<CandidateSet>& conflicts);
  /// Ends an enumeration of conflicts; `explored`: no set is unexplored any more. Decides whether
  /// the knowledge is complete, and marks the conflicts that are minimal.
  void concludeEnumeration(bool explored);

 private:
  void learnAchieved(const CandidateSet& set, task::Plan plan);
  SubsetMap& map();

  const GoalSetTask& task_;
  CandidateSet reached_;  // candidates seen true in some reachable state
  CandidateSet never_true_;
  ConflictSet conflicts_;
  AchievedSets achieved_;
  // An index of the two. Made when it is first needed, since a dialogue may do without, and made
  // anew after something was taken back, which a formula cannot do.
  std::unique_ptr<SubsetMap> map_;
  bool complete_ = false;
};

}  // namespace goal_alignment::achievability
