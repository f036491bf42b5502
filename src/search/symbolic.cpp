// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/symbolic.h"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>

#include "downward_closure.h"
#include "events.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/search/decision_diagram.h"
#include "group_order.h"
#include "path_finder.h"
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

  /// Tries the orders in turn, with ever more steps: at most about five times what the best takes.
  LimitReason run(const Limits& limits) {
    try {
      events_ = makeEvents(task_, groups_, limits);
      const std::vector<GroupOrder> orders = groupOrders(groups_.groups().size(), events_, limits);
      std::uint64_t left = limits.states;
      for (std::uint64_t steps = kFirstSteps;; steps *= 4) {
        for (const GroupOrder& order : orders) {
          const LimitReason reason = attempt(order, limits.withStates(std::min(steps, left)));
          if (reason != LimitReason::States) return reason;
          left -= std::min(steps, left);
          if (left == 0) return reason;
        }
      }
    } catch (const LimitReached& reached) {
      return reached.reason();
    }
  }

  bool complete() const { return reached_ != DecisionDiagram::kEmpty; }

  /// Some reachable state with all these facts, by level.
  std::optional<std::vector<Value>> reachedState(const FactSet& facts) const {
    std::vector<std::optional<Value>> wanted(level_of_.size());
    for (const FactId fact : facts) {
      const MutexGroups::Place place = groups_.place(fact);
      std::optional<Value>& at = wanted[level_of_[place.group]];
      if (at && *at != place.value) return std::nullopt;
      at = place.value;
    }
    std::unordered_set<Node> failed = {DecisionDiagram::kEmpty};
    std::vector<Value> state;
    if (!meet(reached_, wanted, failed, state)) return std::nullopt;
    return state;
  }

  task::Plan plan(const std::vector<Value>& state, const Limits& limits) {
    diagram_->limit(limits);
    if (!path_finder_) path_finder_.emplace(*diagram_, events_, level_of_);
    return path_finder_->path(initial(), state);
  }

  MinimalConflicts minimalConflicts(const task::Goal& goal, const FactSet& candidates,
                                    std::size_t most, const Limits& limits) const {
    MinimalConflicts conflicts;
    std::vector<FactSet> choices(level_of_.size());  // by level
    for (const FactId fact : candidates)
      choices[level_of_[groups_.place(fact).group]].push_back(fact);
    std::vector<Value> domains;
    for (const FactSet& choice : choices) {
      if (!choice.empty()) domains.push_back(static_cast<Value>(choice.size()) + 1);
    }
    DecisionDiagram diagram(std::move(domains));
    diagram.limit(limits);
    try {
      DecisionDiagram::Frame held(diagram, 2);
      for (const FactSet& alternative : goal.alternatives) {
        const auto views = viewsOf(choices, alternative);
        if (!views) continue;
        held[1] = closedBelow(*diagram_, reached_, *views, diagram);
        held[0] = diagram.unite(held[0], held[1]);
      }
      held[1] = minimalOutside(diagram, held[0]);
      list(diagram, held[1], choices, most, conflicts);
      if (conflicts.all) addPairs(choices, most, conflicts);
    } catch (const LimitReached& reached) {
      conflicts.limit = reached.reason();
    }
    return conflicts;
  }

  double stateCount() const { return diagram_->count(reached_); }
  std::size_t nodeCount() const { return diagram_->size(reached_); }
  std::size_t bytes() const { return diagram_ ? diagram_->bytes() : 0; }

 private:
  /// Closes the initial state under the events, with this order of levels.
  LimitReason attempt(const GroupOrder& order, const Limits& limits) {
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
      Saturation saturation(*diagram_, events_, level_of_);
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

  /// A state seen by which candidate of each group it has, 0 for none; those that don't satisfy the
  /// goal are hidden. Nothing where two facts of the goal are of one group.
  std::optional<std::vector<LevelView>> viewsOf(const std::vector<FactSet>& choices,
                                                const FactSet& goal) const {
    std::vector<LevelView> views(choices.size());
    for (std::size_t level = 0; level < views.size(); ++level) {
      views[level].seen_as.assign(diagram_->domain(level), 0);
      for (const FactId fact : choices[level])
        views[level].seen_as[groups_.place(fact).value] = views[level].values++;
    }
    for (const FactId fact : goal) {
      const MutexGroups::Place place = groups_.place(fact);
      std::vector<Value>& seen_as = views[level_of_[place.group]].seen_as;
      if (seen_as[place.value] == LevelView::kHidden) return std::nullopt;
      for (Value value = 0; value < seen_as.size(); ++value) {
        if (value != place.value) seen_as[value] = LevelView::kHidden;
      }
    }
    return views;
  }

  /// The vectors of the set, as candidates.
  static void list(DecisionDiagram& diagram, Node set, const std::vector<FactSet>& choices,
                   std::size_t most, MinimalConflicts& conflicts) {
    std::vector<const FactSet*> choice;
    for (const FactSet& facts : choices) {
      if (!facts.empty()) choice.push_back(&facts);
    }
    conflicts.all = forEachVector(diagram, set, [&](const std::vector<Value>& vector) {
      diagram.step();
      if (conflicts.sets.size() == most) return false;
      FactSet facts;
      for (std::size_t level = 0; level < vector.size(); ++level) {
        if (vector[level] != 0) facts.push_back((*choice[level])[vector[level] - 1]);
      }
      conflicts.sets.push_back(task::makeFactSet(std::move(facts)));
      return true;
    });
  }

  /// Two candidates of one group are a conflict, unless one of them is on its own. No vector has
  /// both, so no other conflict does.
  static void addPairs(const std::vector<FactSet>& choices, std::size_t most,
                       MinimalConflicts& conflicts) {
    std::set<FactId> alone;
    for (const FactSet& known : conflicts.sets) {
      if (known.empty()) return;
      if (known.size() == 1) alone.insert(known[0]);
    }
    for (const FactSet& facts : choices) {
      for (std::size_t i = 0; i < facts.size(); ++i) {
        for (std::size_t j = i + 1; j < facts.size(); ++j) {
          if (alone.count(facts[i]) + alone.count(facts[j]) > 0) continue;
          conflicts.all = conflicts.sets.size() < most;
          if (!conflicts.all) return;
          conflicts.sets.push_back({facts[i], facts[j]});
        }
      }
    }
  }

  /// Goes on from a state down to the node, to one with the wanted values.
  bool meet(Node node, const std::vector<std::optional<Value>>& wanted,
            std::unordered_set<Node>& failed, std::vector<Value>& state) const {
    if (node == DecisionDiagram::kEnd) return true;
    if (failed.count(node) > 0) return false;
    const std::optional<Value> only = wanted[state.size()];
    for (Value value = 0; value < diagram_->domain(state.size()); ++value) {
      if (only && *only != value) continue;
      const Node child = diagram_->child(node, value);
      state.push_back(value);
      if (meet(child, wanted, failed, state)) return true;
      state.pop_back();
    }
    failed.insert(node);
    return false;
  }

  const task::Task& task_;
  const MutexGroups& groups_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> level_of_;  // by group
  std::optional<DecisionDiagram> diagram_;
  std::optional<DecisionDiagram::Frame> held_;  // reached_
  std::optional<PathFinder> path_finder_;
  Node reached_ = DecisionDiagram::kEmpty;
};

Symbolic::Symbolic(const task::Task& task, const MutexGroups& groups)
    : implementation_(std::make_unique<Implementation>(task, groups)) {}

Symbolic::~Symbolic() = default;

LimitReason Symbolic::run(const Limits& limits) {
  if (complete()) return LimitReason::None;
  return implementation_->run(limits);
}

bool Symbolic::complete() const {
  return implementation_->complete();
}

bool Symbolic::reachable(const task::Goal& goal) const {
  return std::any_of(goal.alternatives.begin(), goal.alternatives.end(), [&](const FactSet& facts) {
    return implementation_->reachedState(facts).has_value();
  });
}

std::optional<task::Plan> Symbolic::plan(const task::Goal& goal, const Limits& limits) {
  for (const FactSet& facts : goal.alternatives) {
    const auto state = implementation_->reachedState(facts);
    if (!state) continue;
    try {
      return implementation_->plan(*state, limits);
    } catch (const LimitReached&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

MinimalConflicts Symbolic::minimalConflicts(const task::Goal& goal, const FactSet& candidates,
                                            std::size_t most, const Limits& limits) const {
  return implementation_->minimalConflicts(goal, candidates, most, limits);
}

double Symbolic::stateCount() const {
  return implementation_->stateCount();
}

std::size_t Symbolic::nodeCount() const {
  return implementation_->nodeCount();
}

std::size_t Symbolic::bytes() const {
  return implementation_->bytes();
}

}  // namespace goal_alignment::search
