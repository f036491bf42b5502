// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/shrunk.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracles/seeds.h"

namespace goal_alignment::achievability {
namespace {

RC_GTEST_PROP(Shrunk, IsMinimalForAMonotoneProperty, ()) {
  RandomSource random = oracles::anySource();
  const std::size_t candidates = 1 + random.below(10);
  const std::uint64_t sets = std::uint64_t{1} << candidates;
  const CandidateSet a(candidates, random.below(sets));
  const CandidateSet b(candidates, random.below(sets));
  const auto holds = [&](const CandidateSet& set) {
    return a.is_subset_of(set) || b.is_subset_of(set);
  };
  const CandidateSet set = CandidateSet(candidates, random.below(sets)) | a;
  const CandidateSet result = shrunk(set, holds);
  RC_ASSERT(result.is_subset_of(set));
  RC_ASSERT(holds(result));
  for (const std::size_t member : members(result)) {
    CandidateSet without = result;
    RC_ASSERT(!holds(without.reset(member)));
  }
}

TEST(Shrunk, AsksFewTimesForASmallResult) {
  CandidateSet needed(1024);
  needed.set(700);
  int calls = 0;
  const CandidateSet result = shrunk(~CandidateSet(1024), [&](const CandidateSet& set) {
    ++calls;
    return needed.is_subset_of(set);
  });
  EXPECT_EQ(result, needed);
  EXPECT_LE(calls, 25);
}

TEST(Shrunk, TheEmptySetStays) {
  EXPECT_TRUE(shrunk(CandidateSet(3), [](const CandidateSet&) { return true; }).none());
}

}  // namespace
}  // namespace goal_alignment::achievability
