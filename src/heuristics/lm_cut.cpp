// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/lm_cut.h"

#include <algorithm>
#include <cassert>

namespace goal_alignment::heuristics {

using task::Cost;
using task::FactId;

namespace {

enum Zone : std::uint8_t { NoZone = 0, GoalZone = 1, Seen = 2 };

}  // namespace

LmCut::LmCut(const task::Task& task, const task::FactSet& goal, const CancelToken* cancel)
    : cancel_(cancel),
      relaxed_(task, goal),
      state_words_(task::wordsFor(task.facts.size())),
      facts_(relaxed_.fact_count),
      fresh_operators_(relaxed_.operator_count),
      crosses_(relaxed_.operator_count, 0) {
  for (std::uint32_t op = 0; op < relaxed_.operator_count; ++op) {
    fresh_operators_[op] = {relaxed_.cost[op], 0, 0,
                            static_cast<std::uint32_t>(relaxed_.preconditions.size(op))};
  }
}

void LmCut::reset() {
  operators_ = fresh_operators_;
  std::fill(facts_.begin(), facts_.end(), Fact{0, false, NoZone});
  queue_.clear();
}

void LmCut::reach(FactId fact, Cost cost) {
  Fact& target = facts_[fact];
  if (target.reached && target.cost <= cost) return;
  target.reached = true;
  target.cost = cost;
  queue_.push(cost, fact);
}

void LmCut::findSupporter(std::uint32_t op) {
  Operator& target = operators_[op];
  for (const FactId fact : relaxed_.preconditions[op]) {
    if (facts_[fact].cost > facts_[target.supporter].cost) target.supporter = fact;
  }
  target.supporter_cost = facts_[target.supporter].cost;
}

void LmCut::exploreAll(const task::Word* state) {
  reset();
  task::forEachBit(state, state_words_,
                   [this](std::size_t fact) { reach(static_cast<FactId>(fact), 0); });
  reach(relaxed_.true_fact, 0);
  while (!queue_.empty()) {
    const auto [cost, fact] = queue_.pop();
    if (cost > facts_[fact].cost) continue;  // a cheaper way was found meanwhile
    for (const std::uint32_t op : relaxed_.precondition_of[fact]) {
      Operator& reached = operators_[op];
      if (--reached.unsatisfied != 0) continue;
      // Facts come in rising order of cost, so the last one reached is the dearest.
      reached.supporter = fact;
      reached.supporter_cost = cost;
      for (const FactId effect : relaxed_.effects[op])
        reach(effect, cost + reached.cost);
    }
  }
}

void LmCut::exploreAfterCut() {
  for (const std::uint32_t op : cut_) {
    const Cost cost = operators_[op].supporter_cost + operators_[op].cost;
    for (const FactId effect : relaxed_.effects[op])
      reach(effect, cost);
  }
  while (!queue_.empty()) {
    const auto [cost, fact] = queue_.pop();
    if (cost > facts_[fact].cost) continue;
    for (const std::uint32_t op : relaxed_.precondition_of[fact]) {
      Operator& changed = operators_[op];
      if (changed.unsatisfied != 0 || changed.supporter != fact) continue;
      const Cost before = changed.supporter_cost;
      if (before <= cost) continue;
      findSupporter(op);
      if (changed.supporter_cost == before) continue;
      for (const FactId effect : relaxed_.effects[op]) {
        reach(effect, changed.supporter_cost + changed.cost);
      }
    }
  }
}

/// The goal zone: facts from which the goal follows through supporters at no cost. Their h_max is
/// at least the goal's.
void LmCut::enterGoalZone() {
  goal_zone_.assign(1, relaxed_.goal_fact);
  facts_[relaxed_.goal_fact].zone = GoalZone;
  for (std::size_t i = 0; i < goal_zone_.size(); ++i) {
    for (const std::uint32_t op : relaxed_.effect_of[goal_zone_[i]]) {
      const Operator& achiever = operators_[op];
      if (achiever.unsatisfied != 0 || achiever.cost != 0) continue;
      Fact& supporter = facts_[achiever.supporter];
      if (supporter.zone == GoalZone) continue;
      supporter.zone = GoalZone;
      goal_zone_.push_back(achiever.supporter);
    }
  }
}

/// The cut: the operators that lead into the goal zone from a supporter that the state reaches
/// outside of it. Found from the zone backwards, for the zone is small: a supporter with h_max
/// below the goal's is reached by cheapest achievers, none of which touches the zone; only the
/// dearer ones need a look.
void LmCut::findCut() {
  crossing_.clear();
  for (const FactId fact : goal_zone_) {
    for (const std::uint32_t op : relaxed_.effect_of[fact]) {
      if (operators_[op].unsatisfied != 0 || crosses_[op]) continue;
      if (facts_[operators_[op].supporter].zone == GoalZone) continue;
      crosses_[op] = 1;
      crossing_.push_back(op);
    }
  }
  cut_.clear();
  const Cost goal_cost = facts_[relaxed_.goal_fact].cost;
  for (const std::uint32_t op : crossing_) {
    const FactId supporter = operators_[op].supporter;
    if (facts_[supporter].cost < goal_cost || reachedBeforeZone(supporter)) cut_.push_back(op);
  }
  for (const std::uint32_t op : crossing_)
    crosses_[op] = 0;
  for (const FactId fact : goal_zone_)
    facts_[fact].zone = NoZone;
}

/// Searches the justification graph backwards from the fact for one that the state reaches for less
/// than the goal costs, around the zone and the operators that cross into it.
bool LmCut::reachedBeforeZone(FactId fact) {
  const Cost goal_cost = facts_[relaxed_.goal_fact].cost;
  seen_.assign(1, fact);
  facts_[fact].zone = Seen;
  bool found = false;
  for (std::size_t i = 0; i < seen_.size() && !found; ++i) {
    for (const std::uint32_t op : relaxed_.effect_of[seen_[i]]) {
      if (operators_[op].unsatisfied != 0 || crosses_[op]) continue;
      Fact& supporter = facts_[operators_[op].supporter];
      if (supporter.zone != NoZone) continue;
      if (supporter.cost < goal_cost) {
        found = true;
        break;
      }
      supporter.zone = Seen;
      seen_.push_back(operators_[op].supporter);
    }
  }
  for (const FactId seen : seen_)
    facts_[seen].zone = NoZone;
  return found;
}

Cost LmCut::evaluate(const task::Word* state) {
  exploreAll(state);
  const Fact& goal = facts_[relaxed_.goal_fact];
  if (!goal.reached) return kInfinity;
  Cost total = 0;
  while (goal.cost != 0 && (cancel_ == nullptr || !cancel_->cancelled())) {
    enterGoalZone();
    findCut();
    assert(!cut_.empty());
    Cost cheapest = kInfinity;
    for (const std::uint32_t op : cut_)
      cheapest = std::min(cheapest, operators_[op].cost);
    assert(cheapest > 0);
    for (const std::uint32_t op : cut_)
      operators_[op].cost -= cheapest;
    total += cheapest;
    exploreAfterCut();
  }
  return total;
}

}  // namespace goal_alignment::heuristics
