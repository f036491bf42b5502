// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/task/relevance.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::task {

namespace {

/// Walks from the goal's facts to the operators that add them, and on to what these need. A delete
/// that happens under a condition must stay avoidable: so the walk goes from the facts of that
/// condition to the operators that delete them, too.
class BackwardReachability {
 public:
  BackwardReachability(const Task& task, const Limits& limits)
      : task_(task),
        monitor_(limits),
        adders_(task.facts.size()),
        deleters_(task.facts.size()),
        harmful_(task.facts.size(), false) {
    found_.facts.assign(task.facts.size(), false);
    found_.operators.assign(task.operators.size(), false);
    for (OperatorId op = 0; op < task.operators.size(); ++op) {
      poll();
      note(op, nullptr, task.operators[op].add, task.operators[op].del);
      for (const ConditionalEffect& effect : task.operators[op].conditional)
        note(op, &effect, effect.add, effect.del);
    }
  }

  Relevance from(const Goal& goal) {
    for (const FactSet& alternative : goal.alternatives)
      need(alternative);
    while (!open_.empty() || !open_harmful_.empty()) {
      if (!open_.empty()) {
        const FactId fact = open_.back();
        open_.pop_back();
        use(adders_[fact]);
      } else {
        const FactId fact = open_harmful_.back();
        open_harmful_.pop_back();
        use(deleters_[fact]);
        // What adds it must stay avoidable as well.
        for (const Cause& cause : adders_[fact]) {
          if (cause.effect != nullptr) avoid(cause.effect->condition);
        }
      }
    }
    return std::move(found_);
  }

 private:
  /// An operator's effect; null: what it does in any case.
  struct Cause {
    OperatorId op;
    const ConditionalEffect* effect;
  };

  void poll() { pollOrThrow(monitor_, "finding what matters for the goal"); }

  void note(OperatorId op, const ConditionalEffect* effect, const FactSet& add,
            const FactSet& del) {
    for (const FactId fact : add)
      adders_[fact].push_back({op, effect});
    for (const FactId fact : del)
      deleters_[fact].push_back({op, effect});
  }

  void use(const std::vector<Cause>& causes) {
    for (const auto& [op, effect] : causes) {
      poll();
      if (effect != nullptr) need(effect->condition);
      if (found_.operators[op]) continue;
      found_.operators[op] = true;
      need(task_.operators[op].precondition);
      for (const ConditionalEffect& other : task_.operators[op].conditional) {
        if (!other.del.empty()) avoid(other.condition);
      }
    }
  }

  void need(const FactSet& facts) {
    for (const FactId fact : facts) {
      if (!found_.facts[fact]) open_.push_back(fact);
      found_.facts[fact] = true;
    }
  }

  /// Facts that may do harm by being true. Their being true is looked after all the same.
  void avoid(const FactSet& facts) {
    need(facts);
    for (const FactId fact : facts) {
      if (!harmful_[fact]) open_harmful_.push_back(fact);
      harmful_[fact] = true;
    }
  }

  const Task& task_;
  LimitMonitor monitor_;
  std::vector<std::vector<Cause>> adders_;
  std::vector<std::vector<Cause>> deleters_;
  std::vector<bool> harmful_;
  Relevance found_;
  std::vector<FactId> open_;
  std::vector<FactId> open_harmful_;
};

constexpr FactId kDropped = static_cast<FactId>(-1);

class Projector {
 public:
  Projector(const Task& task, const Goal& goal, const Limits& limits)
      : task_(task), goal_(goal), limits_(limits) {}

  Projection run() {
    const Relevance relevant = relevance(task_, goal_, limits_);
    number(relevant.facts);
    LimitMonitor monitor(limits_);
    for (OperatorId op = 0; op < task_.operators.size(); ++op) {
      pollOrThrow(monitor, "leaving out what does not matter");
      if (relevant.operators[op]) addOperator(op);
    }
    result_.task.initial = mapped(task_.initial);
    for (const FactSet& alternative : goal_.alternatives)
      result_.goal.alternatives.push_back(mapped(alternative));
    return std::move(result_);
  }

 private:
  using Key =
      std::tuple<FactSet, FactSet, FactSet, std::vector<std::tuple<FactSet, FactSet, FactSet>>>;

  void number(const std::vector<bool>& relevant) {
    number_.assign(task_.facts.size(), kDropped);
    for (FactId fact = 0; fact < task_.facts.size(); ++fact) {
      if (!relevant[fact]) continue;
      number_[fact] = static_cast<FactId>(result_.task.facts.size());
      result_.task.facts.push_back(task_.facts[fact]);
      result_.facts.push_back(fact);
    }
  }

  FactSet mapped(const FactSet& facts) const {
    FactSet result;
    for (const FactId fact : facts) {
      if (number_[fact] != kDropped) result.push_back(number_[fact]);
    }
    return result;
  }

  void addOperator(OperatorId id) {
    const Operator& original = task_.operators[id];
    Operator op;
    op.precondition = mapped(original.precondition);
    op.add = mapped(original.add);
    op.del = mapped(original.del);
    op.cost = original.cost;
    for (const ConditionalEffect& effect : original.conditional)
      addEffect(effect, op);
    const auto id_here = static_cast<OperatorId>(result_.origin.size());
    const auto [same, is_new] = known_.emplace(keyOf(op), id_here);
    if (is_new) {
      result_.task.operators.push_back(std::move(op));
      result_.origin.push_back(id);
    } else if (op.cost < result_.task.operators[same->second].cost) {
      result_.task.operators[same->second].cost = op.cost;
      result_.origin[same->second] = id;
    }
  }

  void addEffect(const ConditionalEffect& effect, Operator& op) const {
    ConditionalEffect kept = {mapped(effect.condition), mapped(effect.add), mapped(effect.del)};
    if (kept.add.empty() && kept.del.empty()) return;
    op.conditional.push_back(std::move(kept));
  }

  static Key keyOf(const Operator& op) {
    Key key = {op.precondition, op.add, op.del, {}};
    for (const ConditionalEffect& effect : op.conditional)
      std::get<3>(key).emplace_back(effect.condition, effect.add, effect.del);
    return key;
  }

  const Task& task_;
  const Goal& goal_;
  Limits limits_;
  std::vector<FactId> number_;
  std::map<Key, OperatorId> known_;
  Projection result_;
};

}  // namespace

Relevance relevance(const Task& task, const Goal& goal, const Limits& limits) {
  return BackwardReachability(task, limits).from(goal);
}

Projection project(const Task& task, const Goal& goal, const Limits& limits) {
  return Projector(task, goal, limits).run();
}

Plan Projection::original(const Plan& plan) const {
  Plan result;
  result.reserve(plan.size());
  for (const OperatorId op : plan)
    result.push_back(origin[op]);
  return result;
}

}  // namespace goal_alignment::task
