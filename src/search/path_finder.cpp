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
    if (!events_[top].empty()) to = backThroughRings(from, to, top, plan);
  }
}

/// The same back to some state that lower events alone lead to; that state.
PathFinder::Vector PathFinder::backThroughRings(const Vector& from, Vector to, std::size_t top,
                                                task::Plan& plan) {
  Frame rings(diagram_, 1);  // each, then what an event of this level makes of it
  rings[0] = diagram_.single(from);
  rings[0] = forwards_.close(rings[0], top + 1);
  std::size_t last = 0;
  for (; !contains(rings[last], to); last += 2) {
    rings.push(forwards_.after(rings[last], top));
    rings.push(diagram_.unite(rings[last], rings[last + 1]));
    rings[last + 2] = forwards_.close(rings[last + 2], top + 1);
  }
  for (; last > 0; last -= 2) {
    if (contains(rings[last - 2], to)) continue;
    const Vector entry = entryTo(to, rings[last - 1], top);
    findBackwards(entry, std::move(to), top + 1, plan);
    task::OperatorId op = 0;
    to = before(entry, rings[last - 2], top, op);
    plan.push_back(op);
  }
  return to;
}

/// One of the entries from which lower events lead to the state.
PathFinder::Vector PathFinder::entryTo(const Vector& state, Node entries, std::size_t top) {
  Frame held(diagram_, 1);
  held[0] = diagram_.single(state);
  held[0] = backwards_.close(held[0], top + 1);
  held[0] = diagram_.intersect(held[0], entries);
  Vector entry;
  pick(held[0], std::vector<std::vector<Value>>(diagram_.levels()), entry);
  assert(entry.size() == diagram_.levels());
  return entry;
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
