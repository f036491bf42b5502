// SPDX-License-Identifier: BSD-3-Clause
#include "search/landmark_cache.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "oracles/seeds.h"

namespace goal_alignment::search {
namespace {

using heuristics::Landmarks;

/// One landmark of so many operators.
Landmarks landmarks(std::size_t operators) {
  static const std::array<task::OperatorId, 30> ids = {};
  Landmarks result;
  result.add(1, ids.data(), ids.data() + operators);
  return result;
}

// What is kept are the last ones inserted, as many as the bytes allow, each counted once.
RC_GTEST_PROP(LandmarkCache, KeepsTheLastWithinItsBytes, ()) {
  RandomSource random = oracles::anySource();
  const std::size_t most_bytes = landmarks(0).bytes() * (1 + random.below(6));
  LandmarkCache cache(most_bytes);
  std::vector<std::pair<StateId, std::size_t>> kept;  // the oldest first
  for (int i = 0; i < 40; ++i) {
    const auto id = static_cast<StateId>(random.below(8));
    const std::size_t operators = random.below(30);
    cache.insert(id, landmarks(operators));
    for (auto at = kept.begin(); at != kept.end(); ++at) {
      if (at->first != id) continue;
      kept.erase(at);
      break;
    }
    kept.emplace_back(id, operators);
    const auto bytes = [&] {
      std::size_t sum = 0;
      for (const auto& [unused, size] : kept)
        sum += landmarks(size).bytes();
      return sum;
    };
    while (bytes() > most_bytes && kept.size() > 1)
      kept.erase(kept.begin());
    RC_ASSERT(cache.bytes() == bytes());
    for (StateId state = 0; state < 8; ++state) {
      const Landmarks* found = cache.find(state);
      const auto known = std::find_if(kept.begin(), kept.end(),
                                      [&](const auto& entry) { return entry.first == state; });
      RC_ASSERT((found != nullptr) == (known != kept.end()));
      if (found != nullptr) RC_ASSERT(found->bytes() == landmarks(known->second).bytes());
    }
  }
}

TEST(LandmarkCache, AStateInsertedTwiceCountsOnce) {
  LandmarkCache cache(10 * landmarks(20).bytes());
  for (int i = 0; i < 100; ++i)
    cache.insert(7, landmarks(20));
  EXPECT_EQ(cache.bytes(), landmarks(20).bytes());
  ASSERT_NE(cache.find(7), nullptr);
}

}  // namespace
}  // namespace goal_alignment::search
