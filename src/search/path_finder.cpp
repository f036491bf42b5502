// SPDX-License-Identifier: BSD-3-Clause
#include "path_finder.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace goal_alignment::search {

namespace {

std::vector<Event> inverted(std::vector<Event> events) {
  for (Event& event : events) {
    for (LocalChange& change : event.changes) {
      for (auto& [from, to] : change.pairs)
        std::swap(from, to);
    }
  }
  return events;
}

}  // namespace

PathFinder::PathFinder(DecisionDiagram& diagram, const std::vector<Event>& events,
                       const std::vector<std::uint32_t>& level_of)
    : diagram_(diagram),
      events_(diagram.levels()),
      forwards_(diagram, events, level_of),
      backwards_(diagram, inverted(events), level_of) {
  for (Event event : events) {
    std::uint32_t top = static_cast<std::uint32_t>(diagram.levels());
    for (LocalChange& change : event.changes) {
      change.group = level_of[change.group];
      top = std::min(top, change.group);
    }
    events_[top].push_back(std::move(event));
  }
}

task::Plan PathFinder::path(const Vector& from, const Vector& to) {
  task::Plan plan;
  findBackwards(from, to, 0, plan);
  std::reverse(plan.begin(), plan.end());
  return plan;
}

/// Appends the operators of a way, the last one first, that no event with a level above `top` is
/// needed for.
void PathFinder::findBackwards(const Vector& from, Vector to, std::size_t top, task::Plan& plan) {
  for (; from != to; ++top) {
    assert(top < diagram_.levels());
    if (events_[top].empty()) continue;
    Frame ring(diagram_, 1);
    ring[0] = diagram_.single(from);
    ring[0] = forwards_.close(ring[0], top + 1);
    to = backToRing(ring[0], to, top, plan);
  }
}

/// The same back to some state of the ring, which is closed under lower events; that state.
PathFinder::Vector PathFinder::backToRing(Node ring, const Vector& to, std::size_t top,
                                          task::Plan& plan) {
  if (contains(ring, to)) return to;
  Frame held(diagram_, 3);
  held[0] = forwards_.after(ring, top);
  held[1] = diagram_.unite(ring, held[0]);
  held[1] = forwards_.close(held[1], top + 1);
  const Vector last = backToRing(held[1], to, top, plan);
  if (contains(ring, last)) return last;
  held[2] = diagram_.single(last);
  held[2] = backwards_.close(held[2], top + 1);
  held[2] = diagram_.intersect(held[2], held[0]);
  std::vector<std::vector<Value>> any(diagram_.levels());
  Vector entry;
  pick(held[2], any, entry);
  findBackwards(entry, last, top + 1, plan);
  task::OperatorId op = 0;
  Vector state = before(entry, ring, top, op);
  plan.push_back(op);
  return state;
}

/// A state of the ring that one event with this topmost level leads from to the given one.
PathFinder::Vector PathFinder::before(const Vector& state, Node ring, std::size_t top,
                                      task::OperatorId& op) const {
  Vector found;
  for (const Event& event : events_[top]) {
    std::vector<std::vector<Value>> allowed;
    for (const Value value : state)
      allowed.push_back({value});
    bool possible = true;
    for (const LocalChange& change : event.changes) {
      std::vector<Value>& values = allowed[change.group];
      values.clear();
      for (const auto& [from, to] : change.pairs) {
        if (to == state[change.group]) values.push_back(from);
      }
      possible = possible && !values.empty();
    }
    if (!possible || !pick(ring, allowed, found)) continue;
    op = event.op;
    break;
  }
  assert(!found.empty());
  return found;
}

bool PathFinder::contains(Node set, const Vector& state) const {
  for (const Value value : state)
    set = set == DecisionDiagram::kEmpty ? set : diagram_.child(set, value);
  return set != DecisionDiagram::kEmpty;
}

/// Some vector of the set that has an allowed value at each level; no list: all are.
bool PathFinder::pick(Node set, const std::vector<std::vector<Value>>& allowed,
                      Vector& state) const {
  if (set == DecisionDiagram::kEmpty) return false;
  const std::size_t level = state.size();
  if (level == diagram_.levels()) return true;
  for (Value value = 0; value < diagram_.domain(level); ++value) {
    const auto& values = allowed[level];
    if (!values.empty() && std::find(values.begin(), values.end(), value) == values.end()) continue;
    state.push_back(value);
    if (pick(diagram_.child(set, value), allowed, state)) return true;
    state.pop_back();
  }
  return false;
}

}  // namespace goal_alignment::search
