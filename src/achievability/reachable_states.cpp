// SPDX-License-Identifier: BSD-3-Clause
#include "reachable_states.h"

#include <map>
#include <utility>

#include "goal_alignment/search/exhaustive.h"
#include "goal_alignment/task/state.h"
#include "seen_sets.h"

namespace goal_alignment::achievability {

using task::FactId;
using task::FactSet;

namespace {

/// So many times the time of a sweep that did not come to its end make another one worthwhile.
constexpr int kMuchMore = 4;

/// More conflicts than can be looked at one by one.
constexpr std::size_t kMaxConflicts = 10'000;

Limits::Clock::duration halfTimeLeft(const Limits& limits) {
  return (limits.deadline - Limits::Clock::now()) / 2;
}

}  // namespace

bool ReachableStates::sweepIsDue(const Limits& limits) const {
  return !swept_ || halfTimeLeft(limits) >= worthwhile_time_;
}

LimitReason ReachableStates::sweep(const Limits& limits) {
  const Limits::Clock::duration share = halfTimeLeft(limits);
  Limits own = limits;
  own.deadline = Limits::Clock::now() + share;
  worthwhile_time_ = Limits::Clock::duration::max();
  // A diagram that stays small is made faster than the states are visited; where there are too many
  // states to visit, a large one is the last resort.
  sweep_limit_ = makeDiagram(budget_.first_symbolic, own);
  if (isOwnBudget(sweep_limit_)) sweep_limit_ = enumerate(budget_.exhaustive, own);
  if (isOwnBudget(sweep_limit_)) sweep_limit_ = makeDiagram(budget_.symbolic, own);
  if (sweep_limit_ == LimitReason::Time && limits.interruption() == LimitReason::None) {
    worthwhile_time_ = kMuchMore * share;
    sweep_limit_ = LimitReason::States;
  }
  // What a person or the clock interrupted must end now and may be tried again; our own budgets
  // would end it again.
  swept_ = sweep_limit_ != LimitReason::Cancelled && sweep_limit_ != LimitReason::Time;
  return sweep_limit_;
}

/// The diagram may hold half of the memory.
LimitReason ReachableStates::makeDiagram(std::uint64_t steps, const Limits& limits) {
  planner_.countSweep();
  Limits own = limits.withStates(steps);
  own.bytes = limits.bytes / 2;
  const search::SearchTask& task = task_.searchTask();
  auto diagram = std::make_unique<search::Symbolic>(task.task(), task.groups());
  const LimitReason reason = diagram->run(own);
  if (reason == LimitReason::None) diagram_ = std::move(diagram);
  return reason;
}

/// Visits every reachable state and keeps the maximal achieved sets.
LimitReason ReachableStates::enumerate(std::uint64_t states, const Limits& limits) {
  planner_.countSweep();
  search::Exhaustive exhaustive(task_.searchTask());
  SeenSets seen(task_.candidateCount());
  bool memory_left = true;
  const auto visit = [&](search::StateId id, const task::Word* state) {
    memory_left = exhaustive.bytes() + seen.bytes() <= limits.bytes;
    const bool satisfies_goal = task::satisfies(state, task_.specified());
    if (!satisfies_goal && knowledge_.allReached()) return memory_left;
    const CandidateSet now = task_.satisfiedBy(state);
    knowledge_.learnReached(now);
    if (satisfies_goal) seen.add(now, id);
    return memory_left;
  };
  LimitReason reason = exhaustive.run(limits.withStates(states), visit);
  if (!memory_left) reason = LimitReason::Memory;
  if (reason == LimitReason::Cancelled || reason == LimitReason::Time) return reason;
  std::vector<AchievedSets::Achieved> achieved;
  achieved.reserve(seen.maximal().size());
  for (const auto& [set, id] : seen.maximal())
    achieved.push_back({set, exhaustive.plan(id)});
  knowledge_.learnAchieved(std::move(achieved));
  enumerated_ = reason == LimitReason::None;
  return reason;
}

std::optional<std::vector<CandidateSet>> ReachableStates::minimalConflicts(
    const Limits& limits) const {
  std::map<FactId, std::size_t> candidate_of;
  FactSet facts;
  for (std::size_t i = 0; i < task_.candidateCount(); ++i) {
    const std::optional<FactId> fact = task_.factOf(i);
    if (!fact) continue;
    candidate_of.emplace(*fact, i);
    facts.push_back(*fact);
  }
  const search::MinimalConflicts found = diagram_->minimalConflicts(
      task_.specified(), task::makeFactSet(std::move(facts)), kMaxConflicts, limits);
  if (!found.all) return std::nullopt;
  std::vector<CandidateSet> conflicts;
  for (const FactSet& set : found.sets) {
    conflicts.emplace_back(task_.candidateCount());
    for (const FactId fact : set)
      conflicts.back().set(candidate_of.at(fact));
  }
  return conflicts;
}

}  // namespace goal_alignment::achievability
