// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/symbolic.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "events.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/search/decision_diagram.h"
#include "group_order.h"
#include "saturation.h"

namespace goal_alignment::search {

using heuristics::MutexGroups;
using task::FactId;
using task::FactSet;
using Node = DecisionDiagram::Node;
using Value = DecisionDiagram::Value;

namespace {

constexpr std::uint64_t kFirstSteps = 50'000;

}  // namespace

class Symbolic::Implementation {
 public:
  Implementation(const task::Task& task, const MutexGroups& groups)
      : task_(task), groups_(groups) {}

  /// Tries the orders in turn, with ever more steps: at most about three times what the best takes.
  LimitReason run(const Limits& limits) {
    try {
      const std::vector<Event> events = makeEvents(task_, groups_, limits);
      const std::vector<GroupOrder> orders = groupOrders(groups_.groups().size(), events);
      std::uint64_t left = limits.states;
      for (std::uint64_t steps = kFirstSteps;; steps *= 4) {
        for (const GroupOrder& order : orders) {
          const LimitReason reason =
              attempt(events, order, limits.withStates(std::min(steps, left)));
          if (reason != LimitReason::States) return reason;
          left -= std::min(steps, left);
          if (left == 0) return reason;
        }
      }
    } catch (const LimitReached& reached) {
      return reached.reason();
    }
  }

  LimitReason attempt(const std::vector<Event>& events, const GroupOrder& order,
                      const Limits& limits) {
    held_.reset();
    level_of_.assign(order.size(), 0);
    std::vector<Value> domains;
    for (const std::uint32_t group : order) {
      level_of_[group] = static_cast<std::uint32_t>(domains.size());
      domains.push_back(groups_.valueCount(group));
    }
    diagram_.emplace(std::move(domains));
    diagram_->limit(limits);
    try {
      held_.emplace(*diagram_, 1);
      Saturation saturation(*diagram_, events, level_of_);
      (*held_)[0] = diagram_->single(initial());
      const Node closed = saturation.close((*held_)[0]);
      (*held_)[0] = reached_ = closed;
      return LimitReason::None;
    } catch (const LimitReached& reached) {
      held_.reset();
      diagram_.reset();
      return reached.reason();
    }
  }

  std::vector<Value> initial() const {
    std::vector<Value> values(level_of_.size());
    for (std::size_t group = 0; group < level_of_.size(); ++group)
      values[level_of_[group]] = static_cast<Value>(groups_.groups()[group].size());
    for (const FactId fact : task_.initial)
      values[level_of_[groups_.place(fact).group]] = groups_.place(fact).value;
    return values;
  }

  bool reachable(const FactSet& facts) const {
    std::vector<std::optional<Value>> wanted(level_of_.size());
    for (const FactId fact : facts) {
      const MutexGroups::Place place = groups_.place(fact);
      std::optional<Value>& at = wanted[level_of_[place.group]];
      if (at && *at != place.value) return false;
      at = place.value;
    }
    std::unordered_set<Node> failed = {DecisionDiagram::kEmpty};
    return meets(reached_, 0, wanted, failed);
  }

  std::optional<DecisionDiagram> diagram_;
  std::optional<DecisionDiagram::Frame> held_;
  Node reached_ = DecisionDiagram::kEmpty;

 private:
  bool meets(Node node, std::size_t level, const std::vector<std::optional<Value>>& wanted,
             std::unordered_set<Node>& failed) const {
    if (node == DecisionDiagram::kEnd) return true;
    if (failed.count(node) > 0) return false;
    for (Value value = 0; value < diagram_->domain(level); ++value) {
      if (wanted[level] && *wanted[level] != value) continue;
      if (meets(diagram_->child(node, value), level + 1, wanted, failed)) return true;
    }
    failed.insert(node);
    return false;
  }

  const task::Task& task_;
  const MutexGroups& groups_;
  std::vector<std::uint32_t> level_of_;  // by group
};

Symbolic::Symbolic(const task::Task& task, const MutexGroups& groups)
    : implementation_(std::make_unique<Implementation>(task, groups)) {}

Symbolic::~Symbolic() = default;

LimitReason Symbolic::run(const Limits& limits) {
  if (complete()) return LimitReason::None;
  return implementation_->run(limits);
}

bool Symbolic::complete() const {
  return implementation_->reached_ != DecisionDiagram::kEmpty;
}

bool Symbolic::reachable(const task::Goal& goal) const {
  return std::any_of(goal.alternatives.begin(), goal.alternatives.end(),
                     [&](const FactSet& facts) { return implementation_->reachable(facts); });
}

double Symbolic::stateCount() const {
  return implementation_->diagram_->count(implementation_->reached_);
}

std::size_t Symbolic::nodeCount() const {
  return implementation_->diagram_->size(implementation_->reached_);
}

std::size_t Symbolic::bytes() const {
  return implementation_->diagram_ ? implementation_->diagram_->bytes() : 0;
}

}  // namespace goal_alignment::search
