// SPDX-License-Identifier: BSD-3-Clause
#include "partial_search.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/search/greedy.h"
#include "goal_alignment/search/symbolic.h"
#include "goal_alignment/task/relevance.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::achievability {

using search::Result;
using search::SearchTask;
using search::Status;
using task::FactId;
using task::FactSet;
using task::OperatorId;

namespace {

/// A part that takes more states than one share in so many is left to the diagram.
constexpr std::uint64_t kShare = 4;
/// How many steps on diagrams take about as long as one state.
constexpr std::uint64_t kStepsPerState = 20;

/// How many operators are looked at, to make a part, in about the time of one state.
constexpr std::uint64_t kOperatorsPerState = 50;

class PartialSearch {
 public:
  PartialSearch(const SearchTask& task, const heuristics::MutexTable& mutexes,
                const task::Goal& goal, const Limits& limits)
      : task_(task),
        mutexes_(mutexes),
        goal_(goal),
        limits_(limits),
        copies_(task.task().facts.size()) {}

  Result run(const FactSet& first) {
    for (const FactId fact : first)
      keep(fact);
    for (;;) {
      Result result = searchPart();
      if (result.status != Status::Solved) return result;
      const auto missing = missingFact(result.plan);
      if (!missing) return result;
      keep(*missing);
    }
  }

 private:
  const task::Task& whole() const { return task_.task(); }
  bool kept(FactId fact) const { return !copies_[fact].empty(); }

  /// Keeps the fact with whichever of its groups has more kept facts. The conditions of a
  /// conditional effect on what is kept must be kept, too: with less of them it would happen where
  /// it does not.
  void keep(FactId fact) {
    std::vector<FactId> open = {fact};
    while (!open.empty()) {
      const FactId next = open.back();
      open.pop_back();
      if (kept(next)) continue;
      const FactSet& group = task_.groups().groups()[task_.groups().place(next).group];
      const FactSet other = otherGroup(next);
      keepGroup(keptOf(other) > keptOf(group) ? other : group);
      for (const task::Operator& op : whole().operators) {
        for (const task::ConditionalEffect& effect : op.conditional) {
          if (keptOf(effect.add) + keptOf(effect.del) == 0) continue;
          open.insert(open.end(), effect.condition.begin(), effect.condition.end());
        }
      }
    }
  }

  void keepGroup(const FactSet& group) {
    groups_.emplace_back();
    for (const FactId fact : group) {
      const auto copy = static_cast<FactId>(part_facts_.size());
      part_facts_.push_back(whole().facts[fact]);
      copies_[fact].push_back(copy);
      groups_.back().push_back(copy);
    }
  }

  /// A second mutex group of the fact, without those that it is grouped with already; facts that
  /// are kept come first.
  FactSet otherGroup(FactId fact) const {
    FactSet group = {fact};
    const auto own = task_.groups().place(fact).group;
    for (const bool kept_ones : {true, false}) {
      for (FactId next = 0; next < whole().facts.size(); ++next) {
        if (kept(next) != kept_ones || task_.groups().place(next).group == own) continue;
        const bool fits = std::all_of(group.begin(), group.end(),
                                      [&](FactId member) { return mutexes_.mutex(next, member); });
        if (fits) group.push_back(next);
      }
    }
    return group;
  }

  std::size_t keptOf(const FactSet& facts) const {
    return static_cast<std::size_t>(
        std::count_if(facts.begin(), facts.end(), [&](FactId fact) { return kept(fact); }));
  }

  /// Of the facts those that are kept, by their numbers in the part.
  FactSet restricted(const FactSet& facts) const {
    FactSet result;
    for (const FactId fact : facts)
      result.insert(result.end(), copies_[fact].begin(), copies_[fact].end());
    return task::makeFactSet(std::move(result));
  }

  /// The task of the part; `origin` receives its operators' ids in the whole task.
  task::Task part(std::vector<OperatorId>& origin) const {
    task::Task result;
    result.facts = part_facts_;
    result.initial = restricted(whole().initial);
    for (OperatorId id = 0; id < whole().operators.size(); ++id) {
      const task::Operator& op = whole().operators[id];
      task::Operator own;
      own.add = restricted(op.add);
      own.del = restricted(op.del);
      for (const task::ConditionalEffect& effect : op.conditional) {
        if (keptOf(effect.add) + keptOf(effect.del) == 0) continue;
        own.conditional.push_back(
            {restricted(effect.condition), restricted(effect.add), restricted(effect.del)});
      }
      if (own.add.empty() && own.del.empty() && own.conditional.empty()) continue;
      own.precondition = restricted(op.precondition);
      result.operators.push_back(std::move(own));
      origin.push_back(id);
    }
    return result;
  }

  heuristics::MutexGroups groupsOf(const task::Projection& projection) const {
    std::vector<std::size_t> group_of(part_facts_.size());
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      for (const FactId fact : groups_[group])
        group_of[fact] = group;
    }
    std::vector<FactSet> groups(groups_.size());
    for (FactId fact = 0; fact < projection.facts.size(); ++fact)
      groups[group_of[projection.facts[fact]]].push_back(fact);
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                                [](const FactSet& group) { return group.empty(); }),
                 groups.end());
    return {projection.task, std::move(groups)};
  }

  /// A plan of the part, by the operators of the whole task.
  Result searchPart() {
    Result result;
    task::Goal goal;
    for (const FactSet& alternative : goal_.alternatives) {
      goal.alternatives.push_back(restricted(alternative));
      if (!goal.alternatives.back().empty()) continue;
      result.status = Status::Solved;  // by doing nothing
      return result;
    }
    std::vector<OperatorId> origin;
    task::Task own = part(origin);
    const bool conditional = std::any_of(own.operators.begin(), own.operators.end(),
                                         [](const auto& op) { return !op.conditional.empty(); });
    if (conditional) {
      // A projection leaves out operators that only take a value away. Conditional effects rely on
      // each group having at most one value, so they get the task as it is.
      const SearchTask ready(own, {own, groups_});
      result = searchReady(ready, goal);
    } else {
      task::Projection projection = task::project(own, goal);
      const SearchTask ready(projection.task, groupsOf(projection));
      result = searchReady(ready, projection.goal);
      result.plan = projection.original(result.plan);
    }
    for (OperatorId& op : result.plan)
      op = origin[op];
    return result;
  }

  Result searchReady(const SearchTask& part, const task::Goal& goal) {
    const std::uint64_t share = limits_.states / kShare;
    Result result = search::greedy(part, goal, limits_.withStates(std::min(share, left_)));
    const std::uint64_t making = 1 + whole().operators.size() / kOperatorsPerState;
    left_ -= std::min(left_, result.statistics.generated + making);
    if (result.limit != LimitReason::States || left_ == 0) return result;
    search::Symbolic symbolic(part.task(), part.groups());
    constexpr std::uint64_t kMax = std::numeric_limits<std::uint64_t>::max();
    Limits own = limits_;
    own.states = std::min(limits_.states, kMax / kStepsPerState) * kStepsPerState;
    own.bytes = limits_.bytes / 2;
    result.limit = symbolic.run(own);
    if (result.limit != LimitReason::None) return result;
    if (!symbolic.reachable(goal)) {
      result.status = Status::Unsolvable;
    } else if (auto plan = symbolic.plan(goal, own)) {
      result.status = Status::Solved;
      result.plan = std::move(*plan);
    } else {
      result.limit = LimitReason::States;
    }
    return result;
  }

  /// The fact at which the plan fails in the whole task, or which it lacks of the goal. Nothing: it
  /// is a plan. What is kept is as the part says, so the fact is not kept yet.
  std::optional<FactId> missingFact(const task::Plan& plan) const {
    task::State state = task::initialState(whole());
    for (const OperatorId id : plan) {
      const task::Operator& op = whole().operators[id];
      const FactSet lacking = missing(state, op.precondition);
      if (!lacking.empty()) return lacking.front();
      const task::State before = state;
      task::apply(op, before.data(), state.size(), state.data());
    }
    FactSet fewest;
    for (const FactSet& alternative : goal_.alternatives) {
      FactSet lacking = missing(state, alternative);
      if (lacking.empty()) return std::nullopt;
      // Skip the alternatives that the part did not reach; what the others lack is not kept.
      if (keptOf(lacking) > 0) continue;
      if (fewest.empty() || lacking.size() < fewest.size()) fewest = std::move(lacking);
    }
    return fewest.front();
  }

  static FactSet missing(const task::State& state, const FactSet& facts) {
    FactSet result;
    std::copy_if(facts.begin(), facts.end(), std::back_inserter(result),
                 [&](FactId fact) { return !task::testBit(state.data(), fact); });
    return result;
  }

  const SearchTask& task_;
  const heuristics::MutexTable& mutexes_;
  const task::Goal& goal_;
  Limits limits_;
  std::vector<FactSet> copies_;      // by fact of the whole: one in each group of the part
  std::vector<Literal> part_facts_;  // by fact of the part
  std::vector<FactSet> groups_;      // of the part
  std::uint64_t left_ = limits_.states;
};

}  // namespace

Result searchInParts(const SearchTask& task, const heuristics::MutexTable& mutexes,
                     const task::Goal& goal, const FactSet& first, const Limits& limits) {
  Result result;
  result.status = Status::Unsolvable;
  if (goal.alternatives.empty()) return result;
  return PartialSearch(task, mutexes, goal, limits).run(first);
}

}  // namespace goal_alignment::achievability
