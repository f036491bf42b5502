// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/achievability.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/parallel.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/search/astar.h"
#include "goal_alignment/search/greedy.h"
#include "goal_alignment/task/state.h"
#include "subset_map.h"

namespace goal_alignment::achievability {

using grounding::FactStatus;
using task::FactId;
using task::FactSet;

namespace {

/// Beyond so many operators a state takes so much longer that the searches get fewer of them.
constexpr std::uint64_t kOperators = 2'500;
constexpr std::uint64_t kMinStates = 500;

SearchBudget scaled(SearchBudget budget, std::uint64_t operators) {
  if (operators <= kOperators) return budget;
  for (std::uint64_t* states : {&budget.first_greedy, &budget.exhaustive, &budget.second_greedy,
                                &budget.shrinking, &budget.parts, &budget.minimising})
    *states = std::min(*states, std::max(*states * kOperators / operators, kMinStates));
  return budget;
}

}  // namespace

Achievability::Achievability(grounding::GroundTask robot, const std::vector<Literal>& specified,
                             const std::vector<Literal>& candidates, const SearchBudget& budget,
                             const Limits& limits)
    : budget_(scaled(budget, robot.task.operators.size())),
      facts_(candidates.size(), kNoFact),
      always_true_(candidates.size()),
      never_true_(candidates.size()),
      reached_(candidates.size()) {
  LimitMonitor monitor(limits);
  classify(robot, specified, candidates, monitor);
  mutexes_.emplace(robot.task, limits);
  findMutexConflicts(*mutexes_, monitor);
  heuristics::MutexGroups groups = heuristics::mutexGroups(robot.task, *mutexes_, limits);
  task_.emplace(mutexes_->withoutInapplicable(std::move(robot.task)), std::move(groups), limits);
}

Achievability::~Achievability() = default;

void Achievability::classify(const grounding::GroundTask& robot,
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
      reached_.set(i);
    } else {
      never_true_.set(i);
      addConflict({i});
    }
  }
}

void Achievability::addConflict(const std::vector<std::size_t>& candidates) {
  Conflict conflict;
  conflict.members.resize(facts_.size());
  for (const std::size_t candidate : candidates)
    conflict.members.set(candidate);
  // Stages 1 and 2 add the empty conflict, then single candidates, then pairs: what is not dropped
  // as a superset of an earlier one is minimal as far as these stages see. A pair could still hide
  // an unachievable single candidate; minimise() and findAllConflicts() settle that.
  conflict.minimal = candidates.empty();
  conflicts_.add(conflict);
}

void Achievability::findMutexConflicts(const heuristics::MutexTable& mutexes,
                                       LimitMonitor& monitor) {
  auto& alternatives = specified_.alternatives;
  const auto impossible = [&](const FactSet& facts) { return mutexes.contains(facts); };
  alternatives.erase(std::remove_if(alternatives.begin(), alternatives.end(), impossible),
                     alternatives.end());
  if (alternatives.empty()) addConflict({});
  // By candidate: the alternatives of the goal that it does not rule out.
  std::vector<CandidateSet> possible(facts_.size(), CandidateSet(alternatives.size()));
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    pollOrThrow(monitor, "looking at the candidates");
    if (facts_[i] == kNoFact) continue;
    if (mutexes.mutex(facts_[i], facts_[i])) never_true_.set(i);
    for (std::size_t k = 0; k < alternatives.size(); ++k) {
      FactSet with_goal = alternatives[k];
      with_goal.push_back(facts_[i]);
      possible[i].set(k, !mutexes.contains(with_goal));
    }
    if (possible[i].none()) {
      addConflict({i});
    } else {
      open.push_back(i);
    }
  }
  for (std::size_t a = 0; a < open.size(); ++a) {
    for (std::size_t b = a + 1; b < open.size(); ++b) {
      pollOrThrow(monitor, "looking at pairs of candidates");
      const bool mutex = mutexes.mutex(facts_[open[a]], facts_[open[b]]);
      if (mutex || !possible[open[a]].intersects(possible[open[b]]))
        addConflict({open[a], open[b]});
    }
  }
}

CandidateSet Achievability::satisfied(const task::Word* state) const {
  CandidateSet set = always_true_;
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    if (facts_[i] != kNoFact && task::testBit(state, facts_[i])) set.set(i);
  }
  return set;
}

task::Goal Achievability::goalWith(const CandidateSet& set) const {
  FactSet facts;
  for (const std::size_t candidate : members(set)) {
    if (facts_[candidate] != kNoFact) facts.push_back(facts_[candidate]);
  }
  return task::withFacts(specified_, facts);
}

void Achievability::learn(const Conflict& conflict) {
  if (conflicts_.add(conflict) && map_) map_->blockUp(conflict.members);
}

void Achievability::learnAchieved(const CandidateSet& set, task::Plan plan) {
  if (achieved_.covering(set) != nullptr) return;
  achieved_.add(set, std::move(plan));
  if (conflicts_.clearSuspectedWithin(set)) map_.reset();  // it can't take back what it was told
  if (map_) map_->blockDown(set);
  if (set.all()) complete_ = true;
}

void Achievability::recordPlan(const task::Plan& plan) {
  // A specified literal that is never true is no fact, so no state shows that it is missing.
  const bool goal_possible = conflicts_.provenWithin(CandidateSet(facts_.size())) == nullptr;
  task::State state = task::initialState(task());
  for (std::size_t step = 0;; ++step) {
    const CandidateSet now = satisfied(state.data());
    reached_ |= now;
    if (goal_possible && task::satisfies(state.data(), specified_)) {
      learnAchieved(now, {plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(step)});
    }
    if (step == plan.size()) break;
    const task::State before = state;
    task::apply(task().operators[plan[step]], before.data(), state.size(), state.data());
  }
}

void Achievability::recordExecution(const std::vector<GroundName>& actions, const Limits& limits) {
  LimitMonitor monitor(limits);
  std::unordered_map<GroundName, std::vector<task::OperatorId>> ids;
  for (const GroundName& action : actions)
    ids[action];
  for (task::OperatorId op = 0; op < task().operators.size(); ++op) {
    pollOrThrow(monitor, "following the human's plan");
    const auto found = ids.find(task().operators[op].name);
    if (found != ids.end()) found->second.push_back(op);
  }
  task::Plan plan;
  task::State state = task::initialState(task());
  for (const GroundName& action : actions) {
    // One operator for each alternative of its precondition; none where it would change nothing.
    for (const task::OperatorId op : ids.at(action)) {
      if (!task::contains(state.data(), task().operators[op].precondition)) continue;
      const task::State before = state;
      task::apply(task().operators[op], before.data(), state.size(), state.data());
      plan.push_back(op);
      break;
    }
  }
  recordPlan(plan);
}

std::optional<Check> Achievability::recall(const CandidateSet& set) const {
  if (conflicts_.provenWithin(set) != nullptr) return Check{Verdict::Unachievable, {}, {}};
  if (const auto* achieved = achieved_.covering(set)) {
    return Check{Verdict::Achievable, achieved->plan, {}};
  }
  return std::nullopt;
}

Check Achievability::check(const CandidateSet& set, const Limits& limits) {
  if (const auto known = recall(set)) return *known;
  Check result = search(set, limits);
  if (result.verdict == Verdict::Unknown) result = refineUnknown(set, std::move(result), limits);
  if (result.verdict == Verdict::Unknown) last_limit_ = result.limit;
  return result;
}

/// The way from searches to sweeps and back.
Check Achievability::search(const CandidateSet& set, const Limits& limits) {
  Check last;
  if (!swept_ || sweepPaysAgain(limits)) {
    if (const auto found = searchGreedily(set, limits.withStates(budget_.first_greedy), last)) {
      return *found;
    }
    last.limit = sweep(limits);
    if (const auto known = recall(set)) return *known;
  }
  if (exhaustive_complete_) {
    addUnachievable(set, limits);
    return {Verdict::Unachievable, {}, {}};
  }
  if (knowsReachable()) return checkReachable(set, limits);
  if (last.limit != LimitReason::Cancelled && last.limit != LimitReason::Time) {
    const Limits second = limits.withStates(budget_.second_greedy);
    if (const auto found = searchGreedily(set, second, last)) return *found;
  }
  // The states of a search are our own budget: with more memory there would be an answer.
  if (last.limit == LimitReason::States && sweep_limit_ == LimitReason::Memory) {
    last.limit = LimitReason::Memory;
  }
  return last;
}

std::optional<Check> Achievability::searchGreedily(const CandidateSet& set, const Limits& limits,
                                                   Check& last) {
  ++planner_calls_;
  const search::Result result = search::greedy(*task_, goalWith(set), limits);
  auto check = learnFrom(set, result, limits);
  if (!check) last = {Verdict::Unknown, {}, result.limit};
  return check;
}

/// What a search says of the set; nothing where a limit ended it.
std::optional<Check> Achievability::learnFrom(const CandidateSet& set, const search::Result& result,
                                              const Limits& limits) {
  if (result.status == search::Status::LimitReached) return std::nullopt;
  if (result.status == search::Status::Solved) {
    recordPlan(result.plan);
    return Check{Verdict::Achievable, result.plan, {}};
  }
  addUnachievable(set, limits);
  return Check{Verdict::Unachievable, {}, {}};
}

search::Result Achievability::optimalPlan(const CandidateSet& set, const Limits& limits) {
  ++planner_calls_;
  return search::astar(*task_, goalWith(set), limits);
}

search::Improved Achievability::improvedPlan(const CandidateSet& set, const task::Plan& plan,
                                             const Limits& limits) {
  ++planner_calls_;
  return search::improve(*task_, goalWith(set), plan, limits);
}

std::optional<Verdict> Achievability::recallAlone(std::size_t candidate) const {
  if (reached_.test(candidate)) return Verdict::Achievable;
  if (never_true_.test(candidate) || exhaustive_complete_) return Verdict::Unachievable;
  if (!knowsReachable()) return std::nullopt;
  const bool reachable = symbolic_->reachable(FactSet{facts_[candidate]});
  return reachable ? Verdict::Achievable : Verdict::Unachievable;
}

std::vector<Verdict> Achievability::reachableAlone(const Limits& limits) {
  std::vector<Verdict> verdicts(facts_.size(), Verdict::Unknown);
  for (std::size_t next = 0; next < facts_.size();) {
    std::vector<std::size_t> batch;
    for (; next < facts_.size() && batch.size() < kBatch; ++next) {
      if (const auto known = recallAlone(next)) {
        verdicts[next] = *known;
      } else {
        batch.push_back(next);
      }
    }
    std::vector<search::Result> results(batch.size());
    inParallel(batch.size(), budget_.threads, [&](std::size_t i) {
      results[i] = search::greedy(*task_, FactSet{facts_[batch[i]]},
                                  limits.withStates(budget_.second_greedy));
    });
    planner_calls_ += batch.size();
    for (std::size_t i = 0; i < batch.size(); ++i)
      verdicts[batch[i]] = learnAlone(batch[i], results[i]);
  }
  return verdicts;
}

Verdict Achievability::learnAlone(std::size_t candidate, const search::Result& result) {
  if (result.status == search::Status::Solved) {
    recordPlan(result.plan);
    return Verdict::Achievable;
  }
  if (result.status == search::Status::LimitReached) {
    last_limit_ = result.limit;
    return Verdict::Unknown;
  }
  never_true_.set(candidate);
  return Verdict::Unachievable;
}

}  // namespace goal_alignment::achievability
