// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/astar.h"

#include <map>
#include <utility>
#include <vector>

#include "goal_alignment/heuristics/lm_cut.h"
#include "goal_alignment/search/search_space.h"

namespace goal_alignment::search {

using heuristics::kInfinity;
using task::Cost;
using task::OperatorId;

namespace {

/// Ordered by f, then h; the last one in is the first one out.
class OpenList {
 public:
  void push(Cost f, Cost h, StateId id) { buckets_[{f, h}].push_back(id); }
  bool empty() const { return buckets_.empty(); }

  struct Entry {
    Cost f;
    StateId id;
  };
  Entry pop() {
    const auto bucket = buckets_.begin();
    const Entry entry = {bucket->first.first, bucket->second.back()};
    bucket->second.pop_back();
    if (bucket->second.empty()) buckets_.erase(bucket);
    return entry;
  }

 private:
  std::map<std::pair<Cost, Cost>, std::vector<StateId>> buckets_;
};

class AStar {
 public:
  AStar(const task::Task& task, const SuccessorGenerator& successors, const task::FactSet& goal,
        const Limits& limits, Cost upper_bound)
      : task_(task),
        successors_(successors),
        goal_(goal),
        upper_bound_(upper_bound),
        monitor_(limits),
        heuristic_(task, goal, limits.cancel),
        space_(task) {}

  Result run() {
    nodes_.push_back({0, evaluate(SearchSpace::kInitial), false});
    push(SearchSpace::kInitial);
    result_.status = search();
    result_.statistics.generated = monitor_.states();
    result_.statistics.bytes = bytes();
    return std::move(result_);
  }

 private:
  struct Node {
    Cost g;
    Cost h;
    bool closed;
  };

  Cost evaluate(StateId id) {
    ++result_.statistics.evaluated;
    return heuristic_.evaluate(space_.state(id));
  }

  std::size_t bytes() const { return space_.bytes() + nodes_.capacity() * (sizeof(Node) + 8); }

  void push(StateId id) {
    const Node& node = nodes_[id];
    if (node.h == kInfinity || node.g + node.h >= upper_bound_) return;
    open_.push(node.g + node.h, node.h, id);
  }

  Status search() {
    while (!open_.empty()) {
      const auto [f, id] = open_.pop();
      Node& node = nodes_[id];
      if (node.closed || f > node.g + node.h) continue;  // met again on a cheaper way since
      node.closed = true;
      if (task::contains(space_.state(id), goal_)) {
        result_.plan = space_.plan(id);
        result_.cost = node.g;
        return Status::Solved;
      }
      if (!expand(id)) return Status::LimitReached;
    }
    return Status::Unsolvable;
  }

  /// False when a limit was reached.
  bool expand(StateId id) {
    ++result_.statistics.expanded;
    applicable_.clear();
    successors_.forEach(space_.state(id), [this](OperatorId op) { applicable_.push_back(op); });
    for (const OperatorId op : applicable_) {
      result_.limit = monitor_.generated(bytes());
      if (result_.limit != LimitReason::None) return false;
      const Cost g = nodes_[id].g + task_.operators[op].cost;
      const auto [successor, is_new] = space_.insertSuccessor(id, op);
      if (is_new) {
        nodes_.push_back({g, evaluate(successor), false});
      } else {
        if (g >= nodes_[successor].g) continue;
        space_.setWay(successor, id, op);
        nodes_[successor].g = g;
        nodes_[successor].closed = false;
      }
      push(successor);
    }
    return true;
  }

  const task::Task& task_;
  const SuccessorGenerator& successors_;
  const task::FactSet& goal_;
  Cost upper_bound_;
  LimitMonitor monitor_;
  heuristics::LmCut heuristic_;
  SearchSpace space_;
  std::vector<Node> nodes_;
  OpenList open_;
  std::vector<OperatorId> applicable_;
  Result result_;
};

}  // namespace

Result astar(const task::Task& task, const SuccessorGenerator& successors,
             const task::FactSet& goal, const Limits& limits, Cost upper_bound) {
  return AStar(task, successors, goal, limits, upper_bound).run();
}

}  // namespace goal_alignment::search
