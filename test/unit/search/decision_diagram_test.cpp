// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/decision_diagram.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "oracles/seeds.h"
#include "search/downward_closure.h"

namespace goal_alignment::search {
namespace {

using Node = DecisionDiagram::Node;
using Value = DecisionDiagram::Value;
using Vector = std::vector<Value>;
using Vectors = std::set<Vector>;

Vector randomVector(RandomSource& random, const std::vector<Value>& domains) {
  Vector vector;
  for (const Value domain : domains)
    vector.push_back(static_cast<Value>(random.below(domain)));
  return vector;
}

std::vector<Value> randomDomains(RandomSource& random) {
  std::vector<Value> domains(oracles::between(random, 1, 5));
  for (Value& domain : domains)
    domain = static_cast<Value>(oracles::between(random, 1, 4));
  return domains;
}

Vectors randomVectors(RandomSource& random, const std::vector<Value>& domains) {
  Vectors vectors;
  for (std::size_t n = oracles::between(random, 0, 30); n > 0; --n)
    vectors.insert(randomVector(random, domains));
  return vectors;
}

Node make(DecisionDiagram& diagram, const Vectors& vectors) {
  DecisionDiagram::Frame held(diagram, 2);
  for (const Vector& vector : vectors) {
    held[1] = diagram.single(vector);
    held[0] = diagram.unite(held[0], held[1]);
  }
  return held[0];
}

Vectors vectorsOf(const DecisionDiagram& diagram, Node set) {
  Vectors vectors;
  forEachVector(diagram, set, [&](const Vector& vector) { return vectors.insert(vector).second; });
  return vectors;
}

RC_GTEST_PROP(DecisionDiagram, UnitesAndIntersectsAsSetsDo, ()) {
  RandomSource random = oracles::anySource();
  const std::vector<Value> domains = randomDomains(random);
  const Vectors a = randomVectors(random, domains);
  const Vectors b = randomVectors(random, domains);
  DecisionDiagram diagram(domains);
  DecisionDiagram::Frame held(diagram, 4);
  held[0] = make(diagram, a);
  held[1] = make(diagram, b);
  held[2] = diagram.unite(held[0], held[1]);
  held[3] = diagram.intersect(held[0], held[1]);
  Vectors both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
  Vectors either = a;
  either.insert(b.begin(), b.end());
  RC_ASSERT(vectorsOf(diagram, held[0]) == a);
  RC_ASSERT(vectorsOf(diagram, held[2]) == either);
  RC_ASSERT(vectorsOf(diagram, held[3]) == both);
  RC_ASSERT(diagram.count(held[2]) == static_cast<double>(either.size()));
  RC_ASSERT((held[0] == held[1]) == (a == b));
  RC_ASSERT(make(diagram, either) == held[2]);
}

bool isBelow(const Vector& low, const Vector& high) {
  return std::equal(low.begin(), low.end(), high.begin(),
                    [](Value l, Value h) { return l == 0 || l == h; });
}

/// All vectors, the ones with more zeros first.
std::vector<Vector> allVectors(const std::vector<Value>& domains) {
  std::vector<Vector> vectors = {{}};
  for (const Value domain : domains) {
    std::vector<Vector> longer;
    for (const Vector& vector : vectors) {
      for (Value value = 0; value < domain; ++value) {
        longer.push_back(vector);
        longer.back().push_back(value);
      }
    }
    vectors = std::move(longer);
  }
  const auto zeros = [](const Vector& v) { return std::count(v.begin(), v.end(), 0U); };
  std::stable_sort(vectors.begin(), vectors.end(),
                   [&](const Vector& a, const Vector& b) { return zeros(a) > zeros(b); });
  return vectors;
}

RC_GTEST_PROP(DownwardClosure, AndWhatIsMinimalOutsideAreThoseOfTheDefinition, ()) {
  RandomSource random = oracles::anySource();
  const std::vector<Value> domains = randomDomains(random);
  const Vectors set = randomVectors(random, domains);
  DecisionDiagram diagram(domains);
  DecisionDiagram::Frame held(diagram, 3);
  held[0] = make(diagram, set);
  std::vector<LevelView> views;
  std::vector<Value> seen_domains;
  for (const Value domain : domains) {
    LevelView view;
    view.values = static_cast<Value>(oracles::between(random, 1, 3));
    for (Value value = 0; value < domain; ++value) {
      const bool hidden = oracles::chance(random, 0.1);
      view.seen_as.push_back(hidden ? LevelView::kHidden
                                    : static_cast<Value>(random.below(view.values)));
    }
    if (view.values > 1) seen_domains.push_back(view.values);
    views.push_back(view);
  }
  Vectors seen;
  for (const Vector& vector : set) {
    Vector as;
    bool hidden = false;
    for (std::size_t level = 0; level < domains.size(); ++level) {
      const Value value = views[level].seen_as[vector[level]];
      hidden = hidden || value == LevelView::kHidden;
      if (views[level].values > 1) as.push_back(value);
    }
    if (!hidden) seen.insert(as);
  }
  Vectors below;
  Vectors minimal;
  for (const Vector& vector : allVectors(seen_domains)) {
    const auto over = [&](const Vector& other) { return isBelow(vector, other); };
    const auto under = [&](const Vector& other) { return isBelow(other, vector); };
    if (std::any_of(seen.begin(), seen.end(), over)) {
      below.insert(vector);
    } else if (std::none_of(minimal.begin(), minimal.end(), under)) {
      minimal.insert(vector);
    }
  }
  DecisionDiagram target(seen_domains);
  DecisionDiagram::Frame target_held(target, 2);
  target_held[0] = closedBelow(diagram, held[0], views, target);
  RC_ASSERT(vectorsOf(target, target_held[0]) == below);
  target_held[1] = minimalOutside(target, target_held[0]);
  RC_ASSERT(vectorsOf(target, target_held[1]) == minimal);
}

// Far more nodes are made than the bytes hold; those that are held survive, the others make room.
TEST(DecisionDiagram, CollectsWhatNobodyHolds) {
  const std::vector<Value> domains(20, 4);
  RandomSource random(7);
  DecisionDiagram diagram(domains);
  Limits limits;
  limits.bytes = 1'000'000;
  diagram.limit(limits);
  DecisionDiagram::Frame held(diagram, 2);
  Vectors kept;
  for (int i = 0; i < 50; ++i)
    kept.insert(randomVector(random, domains));
  held[0] = make(diagram, kept);
  for (int round = 0; round < 200; ++round) {
    Vectors dropped;
    for (int i = 0; i < 50; ++i)
      dropped.insert(randomVector(random, domains));
    held[1] = make(diagram, dropped);
    EXPECT_EQ(diagram.count(held[1]), static_cast<double>(dropped.size()));
    EXPECT_LE(diagram.bytes(), limits.bytes);
  }
  EXPECT_GT(diagram.collections(), 0U);
  EXPECT_EQ(vectorsOf(diagram, held[0]), kept);
  EXPECT_EQ(make(diagram, kept), held[0]);
}

TEST(DecisionDiagram, IsWholeAfterALimit) {
  const std::vector<Value> domains(20, 4);
  RandomSource random(7);
  DecisionDiagram diagram(domains);
  DecisionDiagram::Frame held(diagram, 2);
  Vectors vectors;
  for (int i = 0; i < 200; ++i)
    vectors.insert(randomVector(random, domains));
  diagram.limit(Limits{}.withStates(100));
  EXPECT_THROW(make(diagram, vectors), LimitReached);
  Limits narrow;
  narrow.bytes = diagram.bytes();
  diagram.limit(narrow);
  try {
    held[0] = DecisionDiagram::kEmpty;
    for (;;) {
      held[1] = diagram.single(randomVector(random, domains));
      held[0] = diagram.unite(held[0], held[1]);
    }
  } catch (const LimitReached& reached) {
    EXPECT_EQ(reached.reason(), LimitReason::Memory);
  }
  EXPECT_LE(diagram.bytes(), narrow.bytes);
  diagram.limit({});
  held[0] = make(diagram, vectors);
  EXPECT_EQ(vectorsOf(diagram, held[0]), vectors);
}

TEST(DecisionDiagram, EqualSetsAreOneNode) {
  DecisionDiagram diagram({2, 3});
  DecisionDiagram::Frame held(diagram, 2);
  held[0] = make(diagram, {{0, 1}, {1, 1}});
  EXPECT_EQ(diagram.child(held[0], 0), diagram.child(held[0], 1));
  EXPECT_EQ(diagram.size(held[0]), 2U);
  EXPECT_EQ(diagram.size(DecisionDiagram::kEmpty), 0U);
}

}  // namespace
}  // namespace goal_alignment::search
