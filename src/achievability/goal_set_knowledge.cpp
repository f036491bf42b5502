// SPDX-License-Identifier: BSD-3-Clause
#include "goal_set_knowledge.h"

#include <algorithm>
#include <utility>

#include "goal_alignment/task/state.h"

namespace goal_alignment::achievability {

GoalSetKnowledge::GoalSetKnowledge(const GoalSetTask& task)
    : task_(task),
      reached_(task.alwaysTrue()),
      never_true_(task.neverTrue()),
      conflicts_(task.conflicts()) {}

std::optional<Check> GoalSetKnowledge::recall(const CandidateSet& set) const {
  if (conflicts_.provenWithin(set) != nullptr) return Check{Verdict::Unachievable, {}, {}};
  if (const auto* achieved = achieved_.covering(set)) {
    return Check{Verdict::Achievable, achieved->plan, {}};
  }
  return std::nullopt;
}

std::optional<Verdict> GoalSetKnowledge::recallAlone(std::size_t candidate) const {
  if (reached_.test(candidate)) return Verdict::Achievable;
  if (never_true_.test(candidate)) return Verdict::Unachievable;
  return std::nullopt;
}

SubsetMap::Unexplored GoalSetKnowledge::unexplored(std::size_t max_sets, const Limits& limits) {
  return map().maximal(max_sets, limits);
}

SubsetMap& GoalSetKnowledge::map() {
  if (map_) return *map_;
  map_ = std::make_unique<SubsetMap>(task_.candidateCount());
  for (const Conflict& conflict : conflicts_.all())
    map_->blockUp(conflict.members);
  for (const Achieved& achieved : achieved_.all())
    map_->blockDown(achieved.set);
  return *map_;
}

void GoalSetKnowledge::learnPlan(const task::Plan& plan) {
  // A specified literal that is never true is no fact, so no state shows that it is missing.
  const bool goal_possible = conflicts_.provenWithin(CandidateSet(reached_.size())) == nullptr;
  const task::Task& task = task_.task();
  task::State state = task::initialState(task);
  for (std::size_t step = 0;; ++step) {
    const CandidateSet now = task_.satisfiedBy(state.data());
    learnReached(now);
    if (goal_possible && task::satisfies(state.data(), task_.specified())) {
      learnAchieved(now, {plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(step)});
    }
    if (step == plan.size()) break;
    const task::State before = state;
    task::apply(task.operators[plan[step]], before.data(), state.size(), state.data());
  }
}

void GoalSetKnowledge::learnAchieved(const CandidateSet& set, task::Plan plan) {
  if (achieved_.covering(set) != nullptr) return;
  achieved_.add(set, std::move(plan));
  if (conflicts_.clearSuspectedWithin(set)) map_.reset();
  if (map_) map_->blockDown(set);
  if (set.all()) complete_ = true;
}

void GoalSetKnowledge::learnAchieved(std::vector<Achieved> maximal) {
  for (const Achieved& achieved : maximal) {
    conflicts_.clearSuspectedWithin(achieved.set);
    if (achieved.set.all()) complete_ = true;
  }
  achieved_.addMaximal(std::move(maximal));
  map_.reset();
}

void GoalSetKnowledge::learnConflict(const Conflict& conflict) {
  if (conflicts_.add(conflict) && map_) map_->blockUp(conflict.members);
}

void GoalSetKnowledge::suspect(const CandidateSet& set) {
  learnConflict({set - task_.alwaysTrue(), false, false});
}

void GoalSetKnowledge::learnAllConflicts(const std::vector<CandidateSet>& conflicts) {
  conflicts_.clearSuspectedWithin(~CandidateSet(reached_.size()));
  map_.reset();
  for (const CandidateSet& members : conflicts)
    learnConflict({members, true, true});
}

void GoalSetKnowledge::concludeEnumeration(bool explored) {
  const bool all_proven = std::all_of(conflicts().begin(), conflicts().end(),
                                      [](const Conflict& conflict) { return conflict.proven; });
  complete_ = explored && all_proven;
  conflicts_.markMinimal(
      [&](const CandidateSet& smaller) { return complete_ || hasPlanFor(smaller); });
}

}  // namespace goal_alignment::achievability
