// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/common/parallel.h"
#include "goal_alignment/search/exhaustive.h"
#include "goal_alignment/search/greedy.h"
#include "partial_search.h"
#include "seen_sets.h"
#include "subset_map.h"

/// The part of Achievability that proves: the exhaustive search (stage 3), the way from an
/// unachievable set to a minimal conflict, and the enumeration of all conflicts.
namespace goal_alignment::achievability {

using task::FactId;
using task::FactSet;

namespace {

/// So many times the time of a sweep that did not come to its end make another one worthwhile.
constexpr int kMuchMore = 4;

/// More conflicts than can be looked at one by one.
constexpr std::size_t kMaxConflicts = 10'000;

/// Whether our own budgets ended it, rather than a person or the clock.
bool isBudget(LimitReason reason) {
  return reason == LimitReason::States || reason == LimitReason::Memory;
}

Limits::Clock::duration halfTimeLeft(const Limits& limits) {
  return (limits.deadline - Limits::Clock::now()) / 2;
}

/// Leaves out of the set what it can do without: `holds` says so of the rest. Large pieces first,
/// then smaller ones, and in the end one by one, so that the result is minimal where `holds` is
/// monotone. O(result · log set) calls that say no, O(log set) that say yes where the result is
/// small.
template <typename Holds>
CandidateSet shrunk(CandidateSet set, Holds&& holds) {
  std::size_t piece = std::max<std::size_t>(set.count() / 2, 1);
  for (;; piece /= 2) {
    const std::vector<std::size_t> all = members(set);
    for (std::size_t begin = 0; begin < all.size(); begin += piece) {
      CandidateSet rest = set;
      for (std::size_t i = begin; i < std::min(begin + piece, all.size()); ++i)
        rest.reset(all[i]);
      if (holds(rest)) set = std::move(rest);
    }
    if (piece <= 1) return set;
  }
}

}  // namespace

/// Stage 3: all reachable states, after which every check is answered without a search. None: that
/// worked out. It may take half of the time that is left.
LimitReason Achievability::sweep(const Limits& limits) {
  const Limits::Clock::duration share = halfTimeLeft(limits);
  Limits own = limits;
  own.deadline = Limits::Clock::now() + share;
  sweep_worthwhile_ = Limits::Clock::duration::max();
  sweep_limit_ = sweepSymbolically(budget_.first_symbolic, own);
  if (isBudget(sweep_limit_)) sweep_limit_ = exhaust(own);
  if (isBudget(sweep_limit_)) sweep_limit_ = sweepSymbolically(budget_.symbolic, own);
  if (sweep_limit_ == LimitReason::Time && limits.interruption() == LimitReason::None) {
    sweep_worthwhile_ = kMuchMore * share;
    sweep_limit_ = LimitReason::States;
  }
  // What a person or the clock broke off must end now, and may be tried anew; our own budgets
  // would end it again.
  swept_ = sweep_limit_ != LimitReason::Cancelled && sweep_limit_ != LimitReason::Time;
  return sweep_limit_;
}

/// Whether the time ended a sweep and there is much more of it now.
bool Achievability::sweepPaysAgain(const Limits& limits) const {
  return halfTimeLeft(limits) >= sweep_worthwhile_;
}

/// The reachable states as a decision diagram. It may hold half of the memory.
LimitReason Achievability::sweepSymbolically(std::uint64_t steps, const Limits& limits) {
  ++planner_calls_;
  Limits own = limits.withStates(steps);
  own.bytes = limits.bytes / 2;
  auto symbolic = std::make_unique<search::Symbolic>(task_->task(), task_->groups());
  const LimitReason reason = symbolic->run(own);
  if (reason == LimitReason::None) symbolic_ = std::move(symbolic);
  return reason;
}

/// With the reachable states at hand a check is a matter of looking; only a plan must be found.
Check Achievability::checkReachable(const CandidateSet& set, const Limits& limits) {
  if (!symbolic_->reachable(goalWith(set))) {
    addUnachievable(set, limits);
    return {Verdict::Unachievable, {}, {}};
  }
  Check last;
  const Limits second = limits.withStates(budget_.second_greedy);
  if (const auto found = searchGreedily(set, second, last)) return *found;
  if (last.limit == LimitReason::States) {
    if (const auto plan = symbolic_->plan(goalWith(set), limits)) {
      recordPlan(*plan);
      return {Verdict::Achievable, *plan, {}};
    }
  }
  return last;
}

/// Visits every reachable state, keeps the maximal achieved sets.
LimitReason Achievability::exhaust(const Limits& limits) {
  ++planner_calls_;
  search::Exhaustive exhaustive(*task_);
  SeenSets seen(facts_.size());
  bool memory_left = true;
  const auto visit = [&](search::StateId id, const task::Word* state) {
    memory_left = exhaustive.bytes() + seen.bytes() <= limits.bytes;
    const bool satisfies_goal = task::satisfies(state, specified_);
    if (!satisfies_goal && reached_.all()) return memory_left;
    const CandidateSet now = satisfied(state);
    reached_ |= now;
    if (satisfies_goal) seen.add(now, id);
    return memory_left;
  };
  LimitReason reason = exhaustive.run(limits.withStates(budget_.exhaustive), visit);
  if (!memory_left) reason = LimitReason::Memory;
  if (reason == LimitReason::Cancelled || reason == LimitReason::Time) return reason;
  std::vector<AchievedSets::Achieved> achieved;
  achieved.reserve(seen.maximal().size());
  for (const auto& [set, id] : seen.maximal()) {
    achieved.push_back({set, exhaustive.plan(id)});
    conflicts_.clearSuspectedWithin(set);
    if (set.all()) complete_ = true;
  }
  achieved_.addMaximal(std::move(achieved));
  map_.reset();
  exhaustive_complete_ = reason == LimitReason::None;
  return reason;
}

/// Whether a set is proven unachievable, by memory or by a search. That takes from the states.
bool Achievability::provenUnachievable(const CandidateSet& set, std::uint64_t& states,
                                       const Limits& limits) {
  if (conflicts_.provenWithin(set) != nullptr) return true;
  if (achieved_.covering(set) != nullptr) return false;
  if (exhaustive_complete_) return true;
  if (knowsReachable()) return !symbolic_->reachable(goalWith(set));
  if (states == 0) return false;
  ++planner_calls_;
  const search::Result result = search::greedy(*task_, goalWith(set), limits.withStates(states));
  states -= std::min(states, result.statistics.generated);
  if (result.status == search::Status::Solved) recordPlan(result.plan);
  return result.status == search::Status::Unsolvable;
}

/// Adds a conflict that could do without none of its members as far as could be proven. Minimal
/// only where plans show it: what is left in may just not have been proven superfluous.
void Achievability::learnTested(const CandidateSet& conflict, const Limits& limits) {
  if (limits.interruption() == LimitReason::None) tested_.insert(conflict);
  const std::vector<std::size_t> all = members(conflict);
  const bool minimal = std::all_of(all.begin(), all.end(), [&](std::size_t candidate) {
    CandidateSet without = conflict;
    return knowsReachable() || achieved_.covering(without.reset(candidate)) != nullptr;
  });
  learn({conflict, true, minimal});
}

/// Shrinks a set proven unachievable to a conflict and adds it.
void Achievability::addUnachievable(const CandidateSet& set, const Limits& limits) {
  learnTested(shrunk(set - always_true_,
                     [&](const CandidateSet& smaller) {
                       std::uint64_t states = budget_.first_greedy;
                       return provenUnachievable(smaller, states, limits);
                     }),
              limits);
}

/// Tests a proven conflict without each of its members, by searching the first time, later by what
/// is known. True: a smaller one has taken its place.
bool Achievability::minimise(const CandidateSet& conflict, const Limits& limits) {
  if (complete_) return false;
  const std::vector<std::size_t> all = members(conflict);
  std::uint64_t left = tested_.count(conflict) == 0 ? budget_.minimising : 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    CandidateSet without = conflict;
    const std::uint64_t share = left / (all.size() - i);
    std::uint64_t unused = share;
    if (provenUnachievable(without.reset(all[i]), unused, limits)) {
      addUnachievable(without, limits);
      return true;
    }
    left -= share - unused;
  }
  learnTested(conflict, limits);
  return false;
}

const Conflict* Achievability::smallConflictWithin(CandidateSet set, const Limits& limits) {
  while (const Conflict* conflict = conflicts_.provenWithin(set)) {
    set = conflict->members;
    if (!minimise(set, limits)) return conflicts_.provenWithin(set);
  }
  return nullptr;
}

void Achievability::suspect(const CandidateSet& set) {
  learn({set - always_true_, false, false});
}

/// Whether a small budget finds no plan for a part of a set that is open.
bool Achievability::remainsUndecided(const CandidateSet& set, const Limits& limits) {
  if (const auto known = recall(set)) return known->verdict == Verdict::Unachievable;
  Check last;
  const auto found = searchGreedily(set, limits.withStates(budget_.shrinking), last);
  if (found) return found->verdict == Verdict::Unachievable;
  return isBudget(last.limit);
}

/// Looks for a proof where that may be enough.
std::optional<Check> Achievability::searchParts(const CandidateSet& set, const Limits& limits) {
  ++planner_calls_;
  FactSet first;
  for (const std::size_t candidate : members(set)) {
    if (facts_[candidate] != kNoFact) first.push_back(facts_[candidate]);
  }
  const search::Result result =
      searchInParts(*task_, *mutexes_, goalWith(set), first, limits.withStates(budget_.parts));
  return learnFrom(set, result, limits);
}

/// The budgets left a set open: looks for what in it makes it so, and suspects that.
Check Achievability::refineUnknown(const CandidateSet& set, Check last, const Limits& limits) {
  // What a small budget leaves open may be no conflict, which a full search then tells. That
  // teaches something each time; but it takes its time, too.
  constexpr int kAttempts = 3;
  const CandidateSet all = set - always_true_;
  CandidateSet open = all;
  for (int attempt = 0; attempt < kAttempts && isBudget(last.limit); ++attempt) {
    open =
        shrunk(all, [&](const CandidateSet& smaller) { return remainsUndecided(smaller, limits); });
    bool settled = searchParts(open, limits).has_value();
    if (!settled && open != all) settled = search(open, limits).verdict != Verdict::Unknown;
    if (const auto known = recall(set)) return *known;
    if (!settled) break;
    open = all;
  }
  const LimitReason interrupted = limits.interruption();
  if (interrupted != LimitReason::None) last.limit = interrupted;
  if (isBudget(last.limit)) suspect(open);
  return last;
}

/// Made when it is needed first, since a dialogue may do without.
SubsetMap& Achievability::map() {
  if (map_) return *map_;
  map_ = std::make_unique<SubsetMap>(facts_.size());
  for (const Conflict& conflict : conflicts_.all())
    map_->blockUp(conflict.members);
  for (const AchievedSets::Achieved& achieved : achieved_.all())
    map_->blockDown(achieved.set);
  return *map_;
}

/// Looks for plans for several sets side by side; true when all have one.
bool Achievability::checkTogether(const std::vector<CandidateSet>& sets, const Limits& limits) {
  std::vector<search::Result> results(sets.size());
  inParallel(sets.size(), budget_.threads, [&](std::size_t i) {
    results[i] = search::greedy(*task_, goalWith(sets[i]), limits.withStates(budget_.first_greedy));
  });
  planner_calls_ += sets.size();
  bool all = true;
  for (const search::Result& result : results) {
    if (result.status == search::Status::Solved) recordPlan(result.plan);
    all = all && result.status == search::Status::Solved;
  }
  return all;
}

/// All conflicts at once, from the reachable states.
bool Achievability::importConflicts(const Limits& limits) {
  std::map<FactId, std::size_t> candidate_of;
  FactSet facts;
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    if (facts_[i] == kNoFact) continue;
    candidate_of.emplace(facts_[i], i);
    facts.push_back(facts_[i]);
  }
  const search::MinimalConflicts found = symbolic_->minimalConflicts(
      specified_, task::makeFactSet(std::move(facts)), kMaxConflicts, limits);
  if (!found.all) return false;
  conflicts_.clearSuspectedWithin(~CandidateSet(facts_.size()));
  map_.reset();
  for (const FactSet& set : found.sets) {
    Conflict conflict;
    conflict.members.resize(facts_.size());
    for (const FactId fact : set)
      conflict.members.set(candidate_of.at(fact));
    conflict.minimal = true;
    learn(conflict);
  }
  return true;
}

/// Looks at unexplored sets until none is left, which is what true says.
bool Achievability::explore(const Limits& limits) {
  // Many sets at a time as long as all of them have plans; one whose plan is not found at once may
  // bring a conflict to light that settles others, too.
  std::size_t together = 1;
  bool taken = false;
  for (std::uint64_t looked_at = 0; !complete_ && looked_at < budget_.open_sets;) {
    if (knowsReachable() && !std::exchange(taken, true) && importConflicts(limits)) return true;
    const SubsetMap::Unexplored open = map().maximal(together, limits);
    if (open.limit != LimitReason::None) last_limit_ = open.limit;
    if (open.limit != LimitReason::None) return false;
    if (open.sets.empty()) return true;
    looked_at += open.sets.size();
    if (open.sets.size() > 1) {
      together = checkTogether(open.sets, limits) ? kBatch : 1;
      continue;
    }
    const Check result = check(open.sets.front(), limits);
    if (result.verdict == Verdict::Achievable) together = kBatch;
    if (result.verdict == Verdict::Unknown && !isBudget(result.limit)) return false;
  }
  if (!complete_) last_limit_ = LimitReason::States;
  return complete_;
}

bool Achievability::findAllConflicts(const Limits& limits) {
  if (complete_) return true;
  const bool explored = explore(limits);
  const bool all_proven = std::all_of(conflicts().begin(), conflicts().end(),
                                      [](const Conflict& conflict) { return conflict.proven; });
  complete_ = explored && all_proven;
  conflicts_.markMinimal([&](const CandidateSet& smaller) {
    return complete_ || achieved_.covering(smaller) != nullptr;
  });
  return complete_;
}

}  // namespace goal_alignment::achievability
