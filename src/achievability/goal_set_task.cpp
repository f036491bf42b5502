// SPDX-License-Identifier: BSD-3-Clause
#include "goal_set_task.h"

#include <algorithm>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::achievability {

using grounding::FactStatus;
using task::FactSet;

GoalSetTask::GoalSetTask(grounding::GroundTask robot, const std::vector<Literal>& specified,
                         const std::vector<Literal>& candidates, const Limits& limits)
    : facts_(candidates.size(), kNoFact),
      always_true_(candidates.size()),
      never_true_(candidates.size()) {
  LimitMonitor monitor(limits);
  classify(robot, specified, candidates, monitor);
  mutexes_.emplace(robot.task, limits);
  findMutexConflicts(monitor);
  heuristics::MutexGroups groups = heuristics::mutexGroups(robot.task, *mutexes_, limits);
  search_task_.emplace(mutexes_->withoutInapplicable(std::move(robot.task)), std::move(groups),
                       limits);
}

void GoalSetTask::classify(const grounding::GroundTask& robot,
                           const std::vector<Literal>& specified,
                           const std::vector<Literal>& candidates, LimitMonitor& monitor) {
  using Kind = FactStatus::Kind;
  specified_ = robot.goal(specified);
  if (specified_.alternatives.empty()) addConflict({});
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    pollOrThrow(monitor, "looking at the candidates");
    const FactStatus status = robot.status(candidates[i]);
    if (status.kind == Kind::Variable) {
      facts_[i] = status.fact;
    } else if (status.kind == Kind::AlwaysTrue) {
      always_true_.set(i);
    } else {
      never_true_.set(i);
      addConflict({i});
    }
  }
}

void GoalSetTask::addConflict(const std::vector<std::size_t>& candidates) {
  Conflict conflict;
  conflict.members.resize(facts_.size());
  for (const std::size_t candidate : candidates)
    conflict.members.set(candidate);
  // The empty conflict comes first, then single candidates, then pairs: what is not dropped as a
  // superset of an earlier one is minimal as far as these stages see. But a member of a pair may be
  // unachievable by itself without these stages seeing it, so only the empty conflict is certainly
  // minimal.
  conflict.minimal = candidates.empty();
  conflicts_.add(conflict);
}

void GoalSetTask::findMutexConflicts(LimitMonitor& monitor) {
  auto& alternatives = specified_.alternatives;
  const auto impossible = [&](const FactSet& facts) { return mutexes_->contains(facts); };
  alternatives.erase(std::remove_if(alternatives.begin(), alternatives.end(), impossible),
                     alternatives.end());
  if (alternatives.empty()) addConflict({});
  // By candidate: the alternatives of the specified goal that it does not rule out.
  std::vector<CandidateSet> possible(facts_.size(), CandidateSet(alternatives.size()));
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    pollOrThrow(monitor, "looking at the candidates");
    if (facts_[i] == kNoFact) continue;
    if (mutexes_->mutex(facts_[i], facts_[i])) never_true_.set(i);
    for (std::size_t k = 0; k < alternatives.size(); ++k) {
      FactSet with_goal = alternatives[k];
      with_goal.push_back(facts_[i]);
      possible[i].set(k, !mutexes_->contains(with_goal));
    }
    if (possible[i].none()) {
      addConflict({i});
    } else {
      open.push_back(i);
    }
  }
  addMutexPairs(open, possible, monitor);
}

void GoalSetTask::addMutexPairs(const std::vector<std::size_t>& open,
                                const std::vector<CandidateSet>& possible, LimitMonitor& monitor) {
  for (std::size_t a = 0; a < open.size(); ++a) {
    for (std::size_t b = a + 1; b < open.size(); ++b) {
      pollOrThrow(monitor, "looking at pairs of candidates");
      const bool mutex = mutexes_->mutex(facts_[open[a]], facts_[open[b]]);
      if (mutex || !possible[open[a]].intersects(possible[open[b]]))
        addConflict({open[a], open[b]});
    }
  }
}

std::optional<task::FactId> GoalSetTask::factOf(std::size_t candidate) const {
  if (facts_[candidate] == kNoFact) return std::nullopt;
  return facts_[candidate];
}

FactSet GoalSetTask::factsOf(const CandidateSet& set) const {
  FactSet facts;
  for (const std::size_t candidate : members(set)) {
    if (facts_[candidate] != kNoFact) facts.push_back(facts_[candidate]);
  }
  return facts;
}

task::Goal GoalSetTask::goalWith(const CandidateSet& set) const {
  return task::withFacts(specified_, factsOf(set));
}

CandidateSet GoalSetTask::satisfiedBy(const task::Word* state) const {
  CandidateSet set = always_true_;
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    if (facts_[i] != kNoFact && task::testBit(state, facts_[i])) set.set(i);
  }
  return set;
}

}  // namespace goal_alignment::achievability
