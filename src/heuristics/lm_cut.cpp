// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/heuristics/lm_cut.h"

#include <algorithm>
#include <cassert>

namespace goal_alignment::heuristics {

using task::Cost;
using task::FactId;

namespace {

Limits cancelledBy(const CancelToken* cancel) {
  Limits limits;
  limits.cancel = cancel;
  return limits;
}

}  // namespace

LmCut::LmCut(const task::Task& task, const task::Goal& goal, const CancelToken* cancel)
    : cancel_(cancel),
      relaxed_(task, goal, cancelledBy(cancel)),
      state_words_(task::wordsFor(task.facts.size())),
      facts_(relaxed_.fact_count),
      fresh_operators_(relaxed_.operator_count),
      marked_(relaxed_.operator_count, 0) {
  for (std::uint32_t op = 0; op < relaxed_.operator_count; ++op) {
    fresh_operators_[op] = {relaxed_.cost[op], 0, 0,
                            static_cast<std::uint32_t>(relaxed_.preconditions.size(op))};
  }
}

void LmCut::reset() {
  operators_ = fresh_operators_;
  std::fill(facts_.begin(), facts_.end(), Fact{0, false, Zone::None});
  queue_.clear();
  landmarks_.clear();
}

/// Takes over the landmarks that don't contain the operator, and their shares of the costs.
void LmCut::inherit(const Landmarks& before, task::OperatorId op) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Landmarks::Landmark landmark = before[i];
    if (std::find(landmark.begin(), landmark.end(), op) != landmark.end()) continue;
    landmarks_.add(landmark.cost, landmark.begin(), landmark.end());
    for (const task::OperatorId member : landmark) {
      for (const std::uint32_t part : relaxed_.parts[member])
        operators_[part].cost -= landmark.cost;
    }
  }
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
    if (operators_[op].unsatisfied != 0)
      continue;  // a part whose effect's condition is out of reach
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
  facts_[relaxed_.goal_fact].zone = Zone::Goal;
  for (std::size_t i = 0; i < goal_zone_.size(); ++i) {
    for (const std::uint32_t op : relaxed_.effect_of[goal_zone_[i]]) {
      const Operator& achiever = operators_[op];
      if (achiever.unsatisfied != 0 || achiever.cost != 0) continue;
      Fact& supporter = facts_[achiever.supporter];
      if (supporter.zone == Zone::Goal) continue;
      supporter.zone = Zone::Goal;
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
      if (operators_[op].unsatisfied != 0 || marked_[op] != 0) continue;
      if (facts_[operators_[op].supporter].zone == Zone::Goal) continue;
      marked_[op] = 1;
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
    marked_[op] = 0;
  for (const FactId fact : goal_zone_)
    facts_[fact].zone = Zone::None;
  for (const FactId fact : settled_)
    facts_[fact].zone = Zone::None;
  settled_.clear();
}

/// Searches the justification graph backwards from the fact for one that the state reaches for less
/// than the goal costs, around the zone and the operators that cross into it. What a search that
/// found none has seen need not be searched again for this cut.
bool LmCut::reachedBeforeZone(FactId fact) {
  if (facts_[fact].zone == Zone::Apart) return false;
  if (facts_[fact].zone == Zone::BeforeGoal) return true;
  const Cost goal_cost = facts_[relaxed_.goal_fact].cost;
  seen_.assign(1, fact);
  facts_[fact].zone = Zone::Seen;
  bool found = false;
  for (std::size_t i = 0; i < seen_.size() && !found; ++i) {
    for (const std::uint32_t op : relaxed_.effect_of[seen_[i]]) {
      if (operators_[op].unsatisfied != 0 || marked_[op] != 0) continue;
      Fact& supporter = facts_[operators_[op].supporter];
      if (supporter.cost < goal_cost || supporter.zone == Zone::BeforeGoal) {
        found = true;
        break;
      }
      if (supporter.zone != Zone::None) continue;
      supporter.zone = Zone::Seen;
      seen_.push_back(operators_[op].supporter);
    }
  }
  for (const FactId seen : seen_)
    facts_[seen].zone = found ? Zone::None : Zone::Apart;
  if (found) {
    facts_[fact].zone = Zone::BeforeGoal;
    settled_.push_back(fact);
  } else {
    settled_.insert(settled_.end(), seen_.begin(), seen_.end());
  }
  return found;
}

/// Lets every operator of the cut pay for the landmark, all of its parts alike.
void LmCut::payForCut() {
  Cost cheapest = kInfinity;
  for (const std::uint32_t op : cut_)
    cheapest = std::min(cheapest, operators_[op].cost);
  assert(cheapest > 0);
  if (relaxed_.several_parts) addSiblings();
  cut_origins_.clear();
  for (const std::uint32_t op : cut_) {
    operators_[op].cost -= cheapest;
    const task::OperatorId origin = relaxed_.origin[op];
    if (op == relaxed_.parts[origin].first[0]) cut_origins_.push_back(origin);
  }
  landmarks_.add(cheapest, cut_origins_.data(), cut_origins_.data() + cut_origins_.size());
}

/// Completes the cut by the parts of its operators that do not cross into the zone.
void LmCut::addSiblings() {
  const std::size_t crossing = cut_.size();
  for (const std::uint32_t op : cut_)
    marked_[op] = 1;
  for (std::size_t i = 0; i < crossing; ++i) {
    for (const std::uint32_t part : relaxed_.parts[relaxed_.origin[cut_[i]]]) {
      if (marked_[part] != 0) continue;
      marked_[part] = 1;
      cut_.push_back(part);
    }
  }
  for (const std::uint32_t op : cut_)
    marked_[op] = 0;
}

Cost LmCut::complete(const task::Word* state) {
  exploreAll(state);
  const Fact& goal = facts_[relaxed_.goal_fact];
  if (!goal.reached) return kInfinity;
  while (goal.cost != 0 && (cancel_ == nullptr || !cancel_->cancelled())) {
    enterGoalZone();
    findCut();
    assert(!cut_.empty());
    payForCut();
    exploreAfterCut();
  }
  return landmarks_.total();
}

Cost LmCut::evaluate(const task::Word* state) {
  reset();
  return complete(state);
}

Cost LmCut::evaluate(const task::Word* state, const Landmarks& before, task::OperatorId op) {
  reset();
  inherit(before, op);
  return complete(state);
}

}  // namespace goal_alignment::heuristics
