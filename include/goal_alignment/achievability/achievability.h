// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_set>
#include <vector>

#include "goal_alignment/achievability/achieved_sets.h"
#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/achievability/conflict_set.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/heuristics/mutexes.h"
#include "goal_alignment/search/anytime.h"
#include "goal_alignment/search/result.h"
#include "goal_alignment/search/search_task.h"
#include "goal_alignment/search/symbolic.h"
#include "goal_alignment/task/task.h"

/// One robot task, many goal sets: which candidates can be had together with the specified goal?
namespace goal_alignment::achievability {

class SubsetMap;

enum class Verdict : std::uint8_t {
  Achievable,    ///< with a plan
  Unachievable,  ///< proven
  Unknown,       ///< a limit was reached; nothing is proven
};

struct Check {
  Verdict verdict = Verdict::Unknown;
  task::Plan plan;                        ///< with Achievable
  LimitReason limit = LimitReason::None;  ///< with Unknown
};

/// How much work each kind of search may do, in generated states. Tasks of very many operators get
/// less, since their states take longer.
struct SearchBudget {
  std::uint64_t first_greedy = 20'000;     ///< before the reachable states are swept
  std::uint64_t first_symbolic = 300'000;  ///< steps on diagrams, for those that stay small
  std::uint64_t exhaustive = 1'000'000;    ///< the states one by one
  std::uint64_t symbolic = 50'000'000;     ///< steps on diagrams, where the states are more
  std::uint64_t second_greedy = 200'000;   ///< where none of this came to its end
  int threads = 1;  ///< for checks that don't depend on each other; the answers are the same
  std::uint64_t shrinking = 5'000;  ///< each time something is left out of a set that stayed open
  std::uint64_t parts =
      100'000;  ///< on parts of the task, to prove that a set so shrunk has no plan
  std::uint64_t open_sets = 5'000;    ///< how many sets one findAllConflicts() looks at
  std::uint64_t minimising = 20'000;  ///< to prove that a conflict has members too many, all in all
};

/// Remembers every set achieved and every conflict, so that what they imply needs no search.
class Achievability {
 public:
  /// Classifies the candidates and finds the conflicts of stages 1 (relaxed reachability, unknown
  /// names) and 2 (h² mutexes). `robot` must have been grounded with `specified` and `candidates`.
  /// Throws LimitReached.
  Achievability(grounding::GroundTask robot, const std::vector<Literal>& specified,
                const std::vector<Literal>& candidates, const SearchBudget& budget,
                const Limits& limits);
  ~Achievability();

  /// Stage 0: a sequence of ground actions known to run; every state on the way that satisfies the
  /// specified goal is an achieved set.
  void recordExecution(const std::vector<GroundName>& actions, const Limits& limits = {});

  /// Can all of `set` be had together with the specified goal? Answers from memory where it can,
  /// else searches: greedily, then through all reachable states (stage 3, at most once), one by one
  /// or symbolically; where that did not come to its end greedily again. Where our own budgets
  /// leave the set open, a suspected conflict within it is known afterwards, as small as was cheap.
  Check check(const CandidateSet& set, const Limits& limits);

  /// Which candidates can be had at all, without the specified goal (those that can't are the
  /// paper's F̂)?
  std::vector<Verdict> reachableAlone(const Limits& limits);
  /// What is known of one candidate without a search.
  std::optional<Verdict> recallAlone(std::size_t candidate) const;

  /// A plan for the set that no plan undercuts in cost; Unknown where the limits end the search.
  search::Result optimalPlan(const CandidateSet& set, const Limits& limits);

  /// A plan for the set made cheaper as long as the limits let.
  search::Improved improvedPlan(const CandidateSet& set, const task::Plan& plan,
                                const Limits& limits);

  /// Finds all minimal conflicts (stage 4: MARCO, see SubsetMap). True: complete. Anytime: what was
  /// found before a limit stays, and the next call goes on from there. Where none ended it, every
  /// set without a plan contains a conflict, be it a suspected one. As many searches as there are
  /// conflicts and maximal sets that can be had, at least: exponential in the worst case.
  bool findAllConflicts(const Limits& limits);

  /// Of all that is wanted, what to give up so that a plan for the rest is known, and no less would
  /// do as far as the checks tell: at most `most` sets, by falling Π (1 − belief) over what is
  /// given up. Best first through the hitting sets of the conflicts within what is wanted, which
  /// checks find on the way (Reiter, "A theory of diagnosis from first principles", 1987); where
  /// those are too many to go through, the rest of the sets found is good, not best. Nothing where
  /// the specified goal alone can't be had, and less where the limits end it.
  std::vector<CandidateSet> alternatives(const CandidateSet& wanted,
                                         const std::vector<double>& belief, std::size_t most,
                                         const Limits& limits);

  /// All minimal conflicts are known, each proven; so at once where everything can be had.
  bool complete() const { return complete_; }

  /// Why the last check() or reachableAlone() that ended Unknown did, or findAllConflicts() before
  /// it came to its end.
  LimitReason lastLimit() const { return last_limit_; }

  /// Records that the limits left the set open.
  void suspect(const CandidateSet& set);

  const std::vector<Conflict>& conflicts() const { return conflicts_.all(); }
  /// A proven conflict within the set, or null.
  const Conflict* provenConflictWithin(const CandidateSet& set) const {
    return conflicts_.provenWithin(set);
  }
  /// The same without the members that it can do without, as far as a short search tells, and
  /// called minimal where the search shows it. Other conflicts may have come and gone afterwards.
  const Conflict* smallConflictWithin(CandidateSet set, const Limits& limits);
  const std::vector<AchievedSets::Achieved>& achieved() const { return achieved_.all(); }

  /// True in every state the robot can reach: settled without a word.
  const CandidateSet& alwaysTrue() const { return always_true_; }

  const task::Task& task() const { return task_->task(); }
  std::size_t candidateCount() const { return facts_.size(); }
  std::size_t plannerCalls() const { return planner_calls_; }

 private:
  static constexpr task::FactId kNoFact = static_cast<task::FactId>(-1);

  void classify(const grounding::GroundTask& robot, const std::vector<Literal>& specified,
                const std::vector<Literal>& candidates, LimitMonitor& monitor);
  void findMutexConflicts(const heuristics::MutexTable& mutexes, LimitMonitor& monitor);
  void addConflict(const std::vector<std::size_t>& candidates);
  void learn(const Conflict& conflict);
  void learnAchieved(const CandidateSet& set, task::Plan plan);
  CandidateSet satisfied(const task::Word* state) const;
  task::Goal goalWith(const CandidateSet& set) const;
  void recordPlan(const task::Plan& plan);
  std::optional<Check> recall(const CandidateSet& set) const;
  std::optional<Check> searchGreedily(const CandidateSet& set, const Limits& limits, Check& last);
  LimitReason sweep(const Limits& limits);
  bool sweepPaysAgain(const Limits& limits) const;
  LimitReason exhaust(const Limits& limits);
  LimitReason sweepSymbolically(std::uint64_t steps, const Limits& limits);
  bool knowsReachable() const { return symbolic_ != nullptr; }
  Check search(const CandidateSet& set, const Limits& limits);
  Check checkReachable(const CandidateSet& set, const Limits& limits);
  Check refineUnknown(const CandidateSet& set, Check last, const Limits& limits);
  bool remainsUndecided(const CandidateSet& set, const Limits& limits);
  std::optional<Check> learnFrom(const CandidateSet& set, const search::Result& result,
                                 const Limits& limits);
  std::optional<Check> searchParts(const CandidateSet& set, const Limits& limits);
  bool importConflicts(const Limits& limits);
  Verdict learnAlone(std::size_t candidate, const search::Result& result);
  void addUnachievable(const CandidateSet& set, const Limits& limits);
  bool provenUnachievable(const CandidateSet& set, std::uint64_t& states, const Limits& limits);
  bool minimise(const CandidateSet& conflict, const Limits& limits);
  void learnTested(const CandidateSet& conflict, const Limits& limits);
  SubsetMap& map();
  bool explore(const Limits& limits);
  bool checkTogether(const std::vector<CandidateSet>& sets, const Limits& limits);

  SearchBudget budget_;
  std::optional<heuristics::MutexTable> mutexes_;
  std::optional<search::SearchTask> task_;  // without the operators that mutexes rule out
  task::Goal specified_;                    // the specified goal, without what is always true
  std::vector<task::FactId> facts_;         // by candidate; kNoFact: always or never true
  CandidateSet always_true_;
  CandidateSet never_true_;
  CandidateSet reached_;  // candidates seen true in some reachable state
  ConflictSet conflicts_;
  std::unordered_set<CandidateSet> tested_;  // conflicts looked at without each of their members
  AchievedSets achieved_;
  std::unique_ptr<SubsetMap> map_;  // of the two; null until it is needed, and needed anew
  std::unique_ptr<search::Symbolic> symbolic_;  // all reachable states, if that worked out
  bool swept_ = false;                          // as far as the budget reaches
  Limits::Clock::duration sweep_worthwhile_ = Limits::Clock::duration::max();  // once more
  bool exhaustive_complete_ = false;
  bool complete_ = false;
  LimitReason sweep_limit_ = LimitReason::None;
  LimitReason last_limit_ = LimitReason::None;
  std::size_t planner_calls_ = 0;
};

}  // namespace goal_alignment::achievability
