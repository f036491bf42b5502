// SPDX-License-Identifier: BSD-3-Clause
#include "search/saturation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <vector>

#include "oracles/seeds.h"
#include "search/downward_closure.h"
#include "search/path_finder.h"

namespace goal_alignment::search {
namespace {

using Node = DecisionDiagram::Node;
using Value = DecisionDiagram::Value;
using Vector = std::vector<Value>;
using Vectors = std::set<Vector>;

constexpr std::uint32_t kLevels = 4;
constexpr Value kDomain = 3;
const std::vector<std::uint32_t> kSameLevels = {0, 1, 2, 3};

/// Relations, where those of operators are functions: a value may become one of several.
std::vector<Event> randomEvents(RandomSource& random) {
  std::vector<Event> events(oracles::between(random, 0, 6));
  for (std::uint32_t id = 0; id < events.size(); ++id) {
    events[id].op = id;
    for (std::uint32_t level = 0; level < kLevels; ++level) {
      if (oracles::chance(random, 0.5) && level != id % kLevels) continue;
      std::set<std::pair<Value, Value>> pairs;
      for (std::size_t n = oracles::between(random, 1, 3); n > 0; --n)
        pairs.emplace(random.below(kDomain), random.below(kDomain));
      events[id].changes.push_back({level, {pairs.begin(), pairs.end()}});
    }
  }
  return events;
}

Vectors after(const Event& event, const Vector& vector) {
  Vectors result = {vector};
  for (const LocalChange& change : event.changes) {
    Vectors changed;
    for (Vector next : result) {
      for (const auto& [from, to] : change.pairs) {
        if (vector[change.group] != from) continue;
        next[change.group] = to;
        changed.insert(next);
      }
    }
    result = changed;
  }
  return result;
}

std::uint32_t top(const Event& event) {
  return event.changes.front().group;
}

Vectors closed(const std::vector<Event>& events, Vectors set, std::size_t first) {
  for (std::vector<Vector> open(set.begin(), set.end()); !open.empty();) {
    const Vector vector = open.back();
    open.pop_back();
    for (const Event& event : events) {
      if (top(event) < first) continue;
      for (const Vector& next : after(event, vector)) {
        if (set.insert(next).second) open.push_back(next);
      }
    }
  }
  return set;
}

Vectors vectorsOf(const DecisionDiagram& diagram, Node set) {
  Vectors vectors;
  forEachVector(diagram, set, [&](const Vector& vector) { return vectors.insert(vector).second; });
  return vectors;
}

Vector randomVector(RandomSource& random) {
  Vector vector;
  for (std::uint32_t level = 0; level < kLevels; ++level)
    vector.push_back(static_cast<Value>(random.below(kDomain)));
  return vector;
}

RC_GTEST_PROP(Saturation, ClosesSetsUnderEvents, ()) {
  RandomSource random = oracles::anySource();
  const std::vector<Event> events = randomEvents(random);
  DecisionDiagram diagram(std::vector<Value>(kLevels, kDomain));
  Saturation saturation(diagram, events, kSameLevels);
  DecisionDiagram::Frame held(diagram, 2);
  Vectors set;
  for (std::size_t n = oracles::between(random, 0, 4); n > 0; --n) {
    const Vector vector = randomVector(random);
    set.insert(vector);
    held[1] = diagram.single(vector);
    held[0] = diagram.unite(held[0], held[1]);
  }
  for (std::uint32_t level = 0; level <= kLevels; ++level) {
    held[1] = saturation.close(held[0], level);
    RC_ASSERT(vectorsOf(diagram, held[1]) == closed(events, set, level));
    if (level == kLevels) break;
    held[1] = saturation.after(held[0], level);
    // A step that leaves everything as it was is none.
    Vectors stepped;
    for (const Event& event : events) {
      for (const Vector& vector : set) {
        if (top(event) != level) continue;
        for (const Vector& next : after(event, vector))
          stepped.insert(next);
      }
    }
    Vectors with_set = vectorsOf(diagram, held[1]);
    with_set.insert(set.begin(), set.end());
    stepped.insert(set.begin(), set.end());
    RC_ASSERT(with_set == stepped);
  }
}

RC_GTEST_PROP(PathFinder, FindsWaysThatCanBeGone, ()) {
  RandomSource random = oracles::anySource();
  const std::vector<Event> events = randomEvents(random);
  DecisionDiagram diagram(std::vector<Value>(kLevels, kDomain));
  PathFinder finder(diagram, events, kSameLevels);
  const Vector from = randomVector(random);
  for (const Vector& to : closed(events, {from}, 0)) {
    Vectors here = {from};
    for (const task::OperatorId op : finder.path(from, to)) {
      Vectors next;
      for (const Vector& vector : here) {
        const Vectors stepped = after(events[op], vector);
        next.insert(stepped.begin(), stepped.end());
      }
      here = next;
    }
    RC_ASSERT(here.count(to) == 1);
  }
}

}  // namespace
}  // namespace goal_alignment::search
