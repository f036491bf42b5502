// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/seen_sets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "oracles/seeds.h"

namespace goal_alignment::achievability {
namespace {

RC_GTEST_PROP(SeenSets, TheMaximalOnesAreThoseOfTheDefinition, ()) {
  RandomSource random = oracles::anySource();
  const std::size_t candidates = 1 + random.below(8);
  SeenSets seen(candidates);
  std::vector<CandidateSet> added;
  for (search::StateId id = 0; id < 40; ++id) {
    const std::size_t bytes = seen.bytes();
    added.emplace_back(candidates, random.below(std::uint64_t{1} << candidates));
    seen.add(added.back(), id);
    RC_ASSERT(seen.bytes() >= bytes);
    std::set<CandidateSet> expected;
    for (const CandidateSet& set : added) {
      if (std::none_of(added.begin(), added.end(),
                       [&](const auto& other) { return set.is_proper_subset_of(other); }))
        expected.insert(set);
    }
    std::set<CandidateSet> found;
    for (const auto& [set, state] : seen.maximal()) {
      RC_ASSERT(added[state] == set);
      found.insert(set);
    }
    RC_ASSERT(found == expected);
    RC_ASSERT(seen.maximal().size() == expected.size());
  }
}

TEST(SeenSets, AccountsForEverySetOnce) {
  constexpr std::size_t kCandidates = 1000;
  SeenSets seen(kCandidates);
  CandidateSet set(kCandidates);
  for (std::size_t i = 0; i < kCandidates; ++i)
    seen.add(set.set(i), 0);
  EXPECT_GE(seen.bytes(), kCandidates * kCandidates / 8);
  const std::size_t bytes = seen.bytes();
  seen.add(set, 0);
  EXPECT_EQ(seen.bytes(), bytes);
}

}  // namespace
}  // namespace goal_alignment::achievability
