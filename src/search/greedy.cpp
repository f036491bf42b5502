// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/greedy.h"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "goal_alignment/heuristics/ff.h"
#include "goal_alignment/search/search_space.h"

namespace goal_alignment::search {

using heuristics::kInfinity;
using task::Cost;
using task::OperatorId;

namespace {

/// How many more expansions the preferred operators get when h falls below its best.
constexpr int kBoost = 1000;

/// An edge that waits: its end is generated and evaluated only when it is popped.
struct Edge {
  StateId from;
  OperatorId op;
};

/// Ordered by a key, of the edge's start; first in, first out.
class OpenList {
 public:
  void push(Cost key, Edge edge) {
    buckets_[key].push_back(edge);
    ++size_;
  }
  bool empty() const { return buckets_.empty(); }
  std::size_t bytes() const { return size_ * sizeof(Edge); }
  Edge pop() {
    const auto bucket = buckets_.begin();
    const Edge edge = bucket->second.front();
    bucket->second.pop_front();
    if (bucket->second.empty()) buckets_.erase(bucket);
    --size_;
    return edge;
  }
  int priority = 0;  ///< the list with the smaller one is served next

 private:
  std::map<Cost, std::deque<Edge>> buckets_;
  std::size_t size_ = 0;
};

/// What is sought: with weight 0 any plan, by h alone.
struct Aim {
  Cost weight = 0;
  Cost upper_bound = kInfinity;
};

class LazySearch {
 public:
  LazySearch(const SearchTask& task, const task::Goal& goal, const Limits& limits, const Aim& aim)
      : task_(task),
        aim_(aim),
        goal_(task.packing().goal(goal)),
        monitor_(limits),
        heuristic_(task.task(), goal, limits),
        space_(task),
        is_preferred_(task.task().operators.size(), false) {}

  Result run() {
    result_.status = search();
    if (result_.status == Status::Solved) {
      result_.plan = space_.plan(goal_state_);
      result_.cost = task::cost(task_.task(), result_.plan);
    }
    result_.statistics.generated = monitor_.states();
    result_.statistics.bytes = bytes();
    return std::move(result_);
  }

 private:
  struct Node {
    Cost g;
    Cost h;
  };

  std::size_t bytes() const {
    return space_.bytes() + nodes_.capacity() * sizeof(Node) + all_.bytes() + preferred_.bytes();
  }

  Status search() {
    nodes_.push_back({0, 0});
    if (aim_.upper_bound <= 0) return Status::Unsolvable;
    if (open(SearchSpace::kInitial)) return Status::Solved;
    while (!all_.empty() || !preferred_.empty()) {
      const Edge edge = nextEdge();
      result_.limit = monitor_.generated(bytes());
      if (result_.limit != LimitReason::None) return Status::LimitReached;
      if (follow(edge)) return Status::Solved;
    }
    return Status::Unsolvable;
  }

  /// True when the edge leads to the goal.
  bool follow(const Edge& edge) {
    const Cost g = nodes_[edge.from].g + task_.task().operators[edge.op].cost;
    if (g >= aim_.upper_bound) return false;
    const auto [id, is_new] = space_.insertSuccessor(edge.from, edge.op);
    if (is_new) {
      nodes_.push_back({g, 0});
    } else {
      if (aim_.weight == 0 || g >= nodes_[id].g) return false;
      space_.setWay(id, edge.from, edge.op);
      nodes_[id].g = g;
    }
    return open(id);
  }

  Edge nextEdge() {
    const bool take_preferred =
        !preferred_.empty() && (all_.empty() || preferred_.priority <= all_.priority);
    OpenList& list = take_preferred ? preferred_ : all_;
    ++list.priority;
    return list.pop();
  }

  Cost key(const Node& node) const {
    return aim_.weight == 0 ? node.h : node.g + aim_.weight * node.h;
  }

  /// Evaluates a state that is new, or reached more cheaply, and opens its edges; true when it
  /// satisfies the goal.
  bool open(StateId id) {
    if (goal_.holdsIn(space_.packed(id))) {
      goal_state_ = id;
      return true;
    }
    ++result_.statistics.evaluated;
    const task::Word* state = space_.state(id);
    const Cost h = heuristic_.evaluate(state);
    if (h == kInfinity) return false;
    nodes_[id].h = h;
    ++result_.statistics.expanded;
    if (h < best_h_) {
      best_h_ = h;
      preferred_.priority -= kBoost;
    }
    for (const OperatorId op : heuristic_.preferred())
      is_preferred_[op] = true;
    task_.successors().forEach(state, [&](OperatorId op) {
      all_.push(key(nodes_[id]), {id, op});
      if (is_preferred_[op]) preferred_.push(key(nodes_[id]), {id, op});
    });
    for (const OperatorId op : heuristic_.preferred())
      is_preferred_[op] = false;
    return false;
  }

  const SearchTask& task_;
  Aim aim_;
  StatePacking::Goal goal_;
  LimitMonitor monitor_;
  heuristics::Ff heuristic_;
  SearchSpace space_;
  std::vector<bool> is_preferred_;
  OpenList all_;
  OpenList preferred_;
  std::vector<Node> nodes_;
  StateId goal_state_ = kNoState;
  Cost best_h_ = kInfinity;
  Result result_;
};

}  // namespace

Result greedy(const SearchTask& task, const task::Goal& goal, const Limits& limits) {
  return resultOf([&] { return LazySearch(task, goal, limits, {}).run(); });
}

Result weighted(const SearchTask& task, const task::Goal& goal, const Limits& limits, Cost weight,
                Cost upper_bound) {
  return resultOf([&] { return LazySearch(task, goal, limits, {weight, upper_bound}).run(); });
}

}  // namespace goal_alignment::search
