// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/astar.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "goal_alignment/heuristics/lm_cut.h"
#include "goal_alignment/search/search_space.h"
#include "goal_alignment/task/relevance.h"
#include "landmark_cache.h"

namespace goal_alignment::search {

using heuristics::kInfinity;
using heuristics::Landmarks;
using task::Cost;
using task::OperatorId;

namespace {

/// What is kept of landmarks may take so much, and no more than a quarter of the limit.
constexpr std::size_t kMaxLandmarkBytes = std::size_t{64} << 20U;

/// Ordered by f, then h; the last one in is the first one out.
class OpenList {
 public:
  struct Entry {
    Cost f;
    StateId id;
  };

  void push(Cost f, Cost h, StateId id) {
    buckets_[{f, h}].push_back(id);
    ++size_;
  }
  bool empty() const { return buckets_.empty(); }
  Entry pop() {
    const auto bucket = buckets_.begin();
    const Entry entry = {bucket->first.first, bucket->second.back()};
    bucket->second.pop_back();
    if (bucket->second.empty()) buckets_.erase(bucket);
    --size_;
    return entry;
  }
  std::size_t bytes() const { return size_ * sizeof(StateId); }

 private:
  std::map<std::pair<Cost, Cost>, std::vector<StateId>> buckets_;
  std::size_t size_ = 0;
};

class AStar {
 public:
  AStar(const SearchTask& task, const task::Goal& goal, const Limits& limits, const Bounds& bounds)
      : task_(task),
        goal_(task.packing().goal(goal)),
        bounds_(bounds),
        monitor_(limits),
        heuristic_(task.task(), goal, limits.cancel),
        space_(task),
        cache_(std::min(kMaxLandmarkBytes, limits.bytes / 4)),
        paid_(task.task().operators.size(), 0) {}

  Result run() {
    nodes_.push_back({});
    if (goal_.holdsIn(space_.packed(SearchSpace::kInitial))) noteGoal(SearchSpace::kInitial);
    push(SearchSpace::kInitial);
    result_.status = search();
    if (result_.status == Status::Solved) {
      result_.plan = space_.plan(best_goal_);
      result_.cost = nodes_[best_goal_].g;
    }
    result_.statistics.generated = monitor_.states();
    result_.statistics.bytes = bytes();
    return std::move(result_);
  }

 private:
  struct Node {
    Cost g = 0;
    Cost h = 0;  // the best lower bound so far; kInfinity: a dead end
    bool evaluated = false;
    bool closed = false;
  };

  std::size_t bytes() const {
    return space_.bytes() + nodes_.capacity() * sizeof(Node) + open_.bytes() + cache_.bytes();
  }

  void push(StateId id) {
    const Node& node = nodes_[id];
    if (node.h == kInfinity || node.g + node.h >= bounds_.upper) return;
    open_.push(node.g + node.h, node.h, id);
  }

  /// A plan is known: only what is cheaper is of interest from now on.
  void noteGoal(StateId id) {
    if (nodes_[id].g >= bounds_.upper) return;
    bounds_.upper = nodes_[id].g;
    best_goal_ = id;
  }

  Status search() {
    while (!open_.empty()) {
      const auto [f, id] = open_.pop();
      if (std::max(f, bounds_.lower) >= bounds_.upper) break;
      Node& node = nodes_[id];
      if (node.closed || f > node.g + node.h) continue;  // met again on a cheaper way since
      if (!node.evaluated) evaluate(id);
      if (node.h == kInfinity) continue;
      if (f < node.g + node.h) {
        push(id);
        result_.limit = monitor_.poll();
        if (result_.limit != LimitReason::None) return Status::LimitReached;
        continue;
      }
      node.closed = true;
      if (!expand(id)) return Status::LimitReached;
    }
    return best_goal_ == kNoState ? Status::Unsolvable : Status::Solved;
  }

  /// Computes LM-cut for a state, from the landmarks of the one it was reached from if they are
  /// still there.
  void evaluate(StateId id) {
    ++result_.statistics.evaluated;
    const auto [parent, op] = space_.way(id);
    const Landmarks* before = parent == kNoState ? nullptr : cache_.find(parent);
    const Cost h = before == nullptr ? heuristic_.evaluate(space_.state(id))
                                     : heuristic_.evaluate(space_.state(id), *before, op);
    nodes_[id].h = std::max(nodes_[id].h, h);
    nodes_[id].evaluated = true;
    if (h != kInfinity) cache_.insert(id, heuristic_.landmarks());
  }

  /// False when a limit was reached.
  bool expand(StateId id) {
    ++result_.statistics.expanded;
    if (cache_.find(id) == nullptr) evaluate(id);
    const Landmarks& landmarks = *cache_.find(id);
    sumUp(landmarks, 1);
    applicable_.clear();
    task_.successors().forEach(space_.state(id),
                               [this](OperatorId op) { applicable_.push_back(op); });
    const bool goes_on = space_.insertSuccessors(
        id, applicable_, [&](StateId successor, bool is_new, OperatorId op) {
          result_.limit = monitor_.generated(bytes());
          if (result_.limit != LimitReason::None) return false;
          const Cost cost = task_.task().operators[op].cost;
          // Both bounds are admissible: the landmarks without the operator stay landmarks, and no
          // operator takes the goal nearer by more than it costs.
          const Cost h = std::max(landmarks.total() - paid_[op], nodes_[id].h - cost);
          reach(successor, is_new, id, op, std::max<Cost>(h, 0));
          return true;
        });
    sumUp(landmarks, -1);
    return goes_on;
  }

  /// Adds up, by operator, what the landmarks that contain it cost; with sign −1 takes it back.
  void sumUp(const Landmarks& landmarks, int sign) {
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      for (const OperatorId op : landmarks[i])
        paid_[op] += sign * landmarks[i].cost;
    }
  }

  void reach(StateId successor, bool is_new, StateId from, OperatorId op, Cost h) {
    const Cost g = nodes_[from].g + task_.task().operators[op].cost;
    if (is_new) {
      nodes_.push_back({g, h, false, false});
    } else {
      Node& known = nodes_[successor];
      known.h = std::max(known.h, h);
      if (g >= known.g) return;
      space_.setWay(successor, from, op);
      known.g = g;
      known.closed = false;
    }
    if (goal_.holdsIn(space_.packed(successor))) noteGoal(successor);
    push(successor);
  }

  const SearchTask& task_;
  StatePacking::Goal goal_;
  Bounds bounds_;
  LimitMonitor monitor_;
  heuristics::LmCut heuristic_;
  SearchSpace space_;
  LandmarkCache cache_;
  std::vector<Node> nodes_;
  OpenList open_;
  std::vector<OperatorId> applicable_;
  std::vector<Cost> paid_;
  StateId best_goal_ = kNoState;
  Result result_;
};

/// What the projection leaves of the groups: mutex they stay.
heuristics::MutexGroups groupsWithin(const task::Projection& projection,
                                     const heuristics::MutexGroups& groups, const Limits& limits) {
  std::vector<task::FactSet> within(groups.groups().size());
  for (task::FactId fact = 0; fact < projection.facts.size(); ++fact)
    within[groups.place(projection.facts[fact]).group].push_back(fact);
  within.erase(std::remove(within.begin(), within.end(), task::FactSet{}), within.end());
  return {projection.task, std::move(within), limits};
}

Result searchRelevant(const SearchTask& task, const task::Goal& goal, const Limits& limits,
                      const Bounds& bounds) {
  task::Projection projection = task::project(task.task(), goal, limits);
  heuristics::MutexGroups groups = groupsWithin(projection, task.groups(), limits);
  const SearchTask relevant(std::move(projection.task), std::move(groups), limits);
  Result result = AStar(relevant, projection.goal, limits, bounds).run();
  result.plan = projection.original(result.plan);
  return result;
}

}  // namespace

Result astar(const SearchTask& task, const task::Goal& goal, const Limits& limits,
             const Bounds& bounds) {
  return resultOf([&] { return searchRelevant(task, goal, limits, bounds); });
}

}  // namespace goal_alignment::search
