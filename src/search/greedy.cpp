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

/// Ordered by the h of the edge's start; first in, first out.
class OpenList {
 public:
  void push(Cost h, Edge edge) {
    buckets_[h].push_back(edge);
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

class Greedy {
 public:
  Greedy(const task::Task& task, const SuccessorGenerator& successors, const task::Goal& goal,
         const Limits& limits)
      : successors_(successors),
        goal_(goal),
        monitor_(limits),
        heuristic_(task, goal),
        space_(task),
        is_preferred_(task.operators.size(), false) {}

  Result run() {
    result_.status = search();
    if (result_.status == Status::Solved) {
      result_.plan = space_.plan(static_cast<StateId>(space_.size() - 1));
    }
    result_.statistics.generated = monitor_.states();
    result_.statistics.bytes = bytes();
    return std::move(result_);
  }

 private:
  std::size_t bytes() const { return space_.bytes() + all_.bytes() + preferred_.bytes(); }

  Status search() {
    if (open(SearchSpace::kInitial)) return Status::Solved;
    while (!all_.empty() || !preferred_.empty()) {
      const Edge edge = nextEdge();
      result_.limit = monitor_.generated(bytes());
      if (result_.limit != LimitReason::None) return Status::LimitReached;
      const auto [id, is_new] = space_.insertSuccessor(edge.from, edge.op);
      if (is_new && open(id)) return Status::Solved;
    }
    return Status::Unsolvable;
  }

  Edge nextEdge() {
    const bool take_preferred =
        !preferred_.empty() && (all_.empty() || preferred_.priority <= all_.priority);
    OpenList& list = take_preferred ? preferred_ : all_;
    ++list.priority;
    return list.pop();
  }

  /// Evaluates a new state and opens its edges; true when it satisfies the goal.
  bool open(StateId id) {
    const task::Word* state = space_.state(id);
    if (task::satisfies(state, goal_)) return true;
    ++result_.statistics.evaluated;
    const Cost h = heuristic_.evaluate(state);
    if (h == kInfinity) return false;
    ++result_.statistics.expanded;
    if (h < best_h_) {
      best_h_ = h;
      preferred_.priority -= kBoost;
    }
    for (const OperatorId op : heuristic_.preferred())
      is_preferred_[op] = true;
    successors_.forEach(state, [&](OperatorId op) {
      all_.push(h, {id, op});
      if (is_preferred_[op]) preferred_.push(h, {id, op});
    });
    for (const OperatorId op : heuristic_.preferred())
      is_preferred_[op] = false;
    return false;
  }

  const SuccessorGenerator& successors_;
  const task::Goal& goal_;
  LimitMonitor monitor_;
  heuristics::Ff heuristic_;
  SearchSpace space_;
  std::vector<bool> is_preferred_;
  OpenList all_;
  OpenList preferred_;
  Cost best_h_ = kInfinity;
  Result result_;
};

}  // namespace

Result greedy(const task::Task& task, const SuccessorGenerator& successors, const task::Goal& goal,
              const Limits& limits) {
  Result result = Greedy(task, successors, goal, limits).run();
  result.cost = task::cost(task, result.plan);
  return result;
}

}  // namespace goal_alignment::search
