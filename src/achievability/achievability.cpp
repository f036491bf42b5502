// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/achievability.h"

#include <unordered_map>
#include <utility>

#include "alternatives.h"
#include "candidates_alone.h"
#include "conflict_enumeration.h"
#include "conflict_minimiser.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/task/state.h"
#include "goal_set_knowledge.h"
#include "goal_set_prover.h"
#include "goal_set_task.h"
#include "planner.h"
#include "reachable_states.h"

namespace goal_alignment::achievability {

/// Each part knows those before it.
struct Achievability::Parts {
  SearchBudget budget;
  GoalSetTask task;
  GoalSetKnowledge knowledge{task};
  Planner planner{task, budget.threads};
  ReachableStates reachable{task, knowledge, planner, budget};
  ConflictMinimiser minimiser{task, knowledge, planner, reachable, budget};
  GoalSetProver prover{task, knowledge, planner, reachable, minimiser, budget};
  CandidatesAlone alone{task, knowledge, planner, reachable, budget};
  ConflictEnumeration enumeration{task, knowledge, planner, reachable, prover, budget};

  Parts(grounding::GroundTask robot, const std::vector<Literal>& specified,
        const std::vector<Literal>& candidates, const SearchBudget& given, const Limits& limits)
      : budget(scaledTo(given, robot.task.operators.size())),
        task(std::move(robot), specified, candidates, limits) {}
};

namespace {

/// The operators that the actions run as, in the task's initial state and onwards. An action that
/// changes nothing has none.
task::Plan followed(const std::vector<GroundName>& actions, const task::Task& task,
                    const Limits& limits) {
  LimitMonitor monitor(limits);
  std::unordered_map<GroundName, std::vector<task::OperatorId>> ids;
  for (const GroundName& action : actions)
    ids[action];
  for (task::OperatorId op = 0; op < task.operators.size(); ++op) {
    pollOrThrow(monitor, "following the human's plan");
    const auto found = ids.find(task.operators[op].name);
    if (found != ids.end()) found->second.push_back(op);
  }
  task::Plan plan;
  task::State state = task::initialState(task);
  for (const GroundName& action : actions) {
    // There is one operator for each alternative of the action's precondition.
    for (const task::OperatorId op : ids.at(action)) {
      if (!task::contains(state.data(), task.operators[op].precondition)) continue;
      const task::State before = state;
      task::apply(task.operators[op], before.data(), state.size(), state.data());
      plan.push_back(op);
      break;
    }
  }
  return plan;
}

}  // namespace

Achievability::Achievability(grounding::GroundTask robot, const std::vector<Literal>& specified,
                             const std::vector<Literal>& candidates, const SearchBudget& budget,
                             const Limits& limits)
    : parts_(std::make_unique<Parts>(std::move(robot), specified, candidates, budget, limits)) {}

Achievability::~Achievability() = default;

void Achievability::recordExecution(const std::vector<GroundName>& actions, const Limits& limits) {
  parts_->knowledge.learnPlan(followed(actions, task(), limits));
}

Check Achievability::check(const CandidateSet& set, const Limits& limits) {
  Check result = parts_->prover.check(set, limits);
  if (result.verdict == Verdict::Unknown) last_limit_ = result.limit;
  return result;
}

std::vector<Verdict> Achievability::reachableAlone(const Limits& limits) {
  std::vector<Verdict> verdicts;
  for (const Check& check : parts_->alone.checkAll(limits)) {
    verdicts.push_back(check.verdict);
    if (check.verdict == Verdict::Unknown) last_limit_ = check.limit;
  }
  return verdicts;
}

std::optional<Verdict> Achievability::recallAlone(std::size_t candidate) const {
  return parts_->alone.recall(candidate);
}

search::Result Achievability::optimalPlan(const CandidateSet& set, const Limits& limits) {
  return parts_->planner.optimal(set, limits);
}

search::Improved Achievability::improvedPlan(const CandidateSet& set, const task::Plan& plan,
                                             const Limits& limits) {
  return parts_->planner.improve(set, plan, limits);
}

bool Achievability::findAllConflicts(const Limits& limits) {
  if (complete()) return true;
  const LimitReason limit = parts_->enumeration.run(limits);
  if (limit != LimitReason::None) last_limit_ = limit;
  return complete();
}

std::vector<CandidateSet> Achievability::alternatives(const CandidateSet& wanted,
                                                      const std::vector<double>& belief,
                                                      std::size_t max_alternatives,
                                                      const Limits& limits) {
  return findAlternatives(*this, wanted, belief, max_alternatives, limits);
}

bool Achievability::complete() const {
  return parts_->knowledge.complete();
}

void Achievability::suspect(const CandidateSet& set) {
  parts_->knowledge.suspect(set);
}

const std::vector<Conflict>& Achievability::conflicts() const {
  return parts_->knowledge.conflicts();
}

const Conflict* Achievability::provenConflictWithin(const CandidateSet& set) const {
  return parts_->knowledge.provenConflictWithin(set);
}

const Conflict* Achievability::smallConflictWithin(const CandidateSet& set, const Limits& limits) {
  return parts_->minimiser.smallConflictWithin(set, limits);
}

const std::vector<AchievedSets::Achieved>& Achievability::achieved() const {
  return parts_->knowledge.achieved();
}

const CandidateSet& Achievability::alwaysTrue() const {
  return parts_->task.alwaysTrue();
}

const task::Task& Achievability::task() const {
  return parts_->task.task();
}

std::size_t Achievability::candidateCount() const {
  return parts_->task.candidateCount();
}

std::size_t Achievability::plannerCalls() const {
  return parts_->planner.calls();
}

}  // namespace goal_alignment::achievability
