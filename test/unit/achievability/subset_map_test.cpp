// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/subset_map.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <set>
#include <vector>

#include "oracles/seeds.h"

namespace goal_alignment::achievability {
namespace {

/// What is explored, by asking every block about every set.
class Blocks {
 public:
  explicit Blocks(std::size_t candidates) : candidates_(candidates) {}

  void addUp(std::uint64_t set) { up_.push_back(set); }
  void addDown(std::uint64_t set) { down_.push_back(set); }

  bool unexplored(std::uint64_t set) const {
    return std::none_of(up_.begin(), up_.end(), [&](auto block) { return (block & ~set) == 0; }) &&
           std::none_of(down_.begin(), down_.end(),
                        [&](auto block) { return (set & ~block) == 0; });
  }

  std::set<std::uint64_t> maximal() const {
    std::set<std::uint64_t> result;
    const std::uint64_t end = std::uint64_t{1} << candidates_;
    for (std::uint64_t set = 0; set < end; ++set) {
      bool largest = unexplored(set);
      // A superset can be unexplored only if one with one candidate more is: blocks from below end
      // where they ended, blocks from above go on.
      for (std::size_t f = 0; largest && f < candidates_; ++f) {
        const std::uint64_t more = set | (std::uint64_t{1} << f);
        largest = more == set || !unexplored(more);
      }
      if (largest) result.insert(set);
    }
    return result;
  }

 private:
  std::size_t candidates_;
  std::vector<std::uint64_t> up_;
  std::vector<std::uint64_t> down_;
};

std::set<std::uint64_t> bits(const std::vector<CandidateSet>& sets) {
  std::set<std::uint64_t> result;
  for (const CandidateSet& set : sets)
    result.insert(set.to_ulong());
  return result;
}

// All of them where more are asked for, and so many of them where fewer are; asked again and again.
RC_GTEST_PROP(SubsetMap, TheMaximalUnexploredSetsEqualBruteForce, ()) {
  RandomSource random = oracles::anySource();
  const std::size_t candidates = random.below(8);
  const std::uint64_t end = std::uint64_t{1} << candidates;
  SubsetMap map(candidates);
  Blocks blocks(candidates);
  for (int i = 0; i < 10; ++i) {
    const std::set<std::uint64_t> expected = blocks.maximal();
    const std::size_t most = oracles::chance(random, 0.5) ? end : 1 + random.below(4);
    const auto found = map.maximal(most, {});
    RC_ASSERT(found.limit == LimitReason::None);
    RC_ASSERT(found.sets.size() == std::min(most, expected.size()));
    const std::set<std::uint64_t> different = bits(found.sets);
    RC_ASSERT(different.size() == found.sets.size());
    RC_ASSERT(std::includes(expected.begin(), expected.end(), different.begin(), different.end()));
    const std::uint64_t block = random.below(end);
    if (oracles::chance(random, 0.6)) {
      map.blockUp(CandidateSet(candidates, block));
      blocks.addUp(block);
    } else {
      map.blockDown(CandidateSet(candidates, block));
      blocks.addDown(block);
    }
  }
}

// The way the map is used, against a monotone property drawn at random.
RC_GTEST_PROP(SubsetMap, ExploresAllConflictsOfAMonotoneProperty, ()) {
  RandomSource random = oracles::anySource();
  const std::size_t candidates = 1 + random.below(9);
  std::set<std::uint64_t> conflicts;
  for (std::uint64_t left = random.below(6); left > 0; --left)
    conflicts.insert(random.below(std::uint64_t{1} << candidates));
  const auto within = [&](std::uint64_t set) {
    return std::find_if(conflicts.begin(), conflicts.end(),
                        [&](std::uint64_t conflict) { return (conflict & ~set) == 0; });
  };
  SubsetMap map(candidates);
  std::set<std::uint64_t> found;
  for (std::size_t steps = 0;; ++steps) {
    RC_ASSERT(steps <= std::size_t{1} << candidates);
    const auto open = map.maximal(1, {});
    if (open.sets.empty()) break;
    const auto conflict = within(open.sets.front().to_ulong());
    if (conflict == conflicts.end()) {
      map.blockDown(open.sets.front());
    } else {
      RC_ASSERT(found.insert(*conflict).second);
      map.blockUp(CandidateSet(candidates, *conflict));
    }
  }
  for (const std::uint64_t conflict : conflicts)
    RC_ASSERT(
        std::any_of(found.begin(), found.end(), [&](auto f) { return (f & ~conflict) == 0; }));
}

TEST(SubsetMap, WithoutCandidatesThereIsTheEmptySet) {
  SubsetMap map(0);
  ASSERT_EQ(map.maximal(3, {}).sets.size(), 1U);
  map.blockDown(CandidateSet(0));
  EXPECT_TRUE(map.maximal(3, {}).sets.empty());
}

TEST(SubsetMap, TheEmptyConflictExploresAll) {
  SubsetMap map(5);
  map.blockUp(CandidateSet(5));
  EXPECT_TRUE(map.maximal(1, {}).sets.empty());
}

// n disjoint pairs leave 2^n maximal sets: any few of them are there at once.
TEST(SubsetMap, ListsAFewOfVeryMany) {
  constexpr std::size_t kPairs = 100;
  SubsetMap map(2 * kPairs);
  for (std::size_t i = 0; i < kPairs; ++i) {
    CandidateSet pair(2 * kPairs);
    map.blockUp(pair.set(2 * i).set(2 * i + 1));
  }
  const auto found = map.maximal(50, {});
  ASSERT_EQ(found.sets.size(), 50U);
  for (const CandidateSet& set : found.sets)
    EXPECT_EQ(set.count(), kPairs);
}

TEST(SubsetMap, GoesOnAfterACancel) {
  CancelToken token;
  Limits limits;
  limits.cancel = &token;
  SubsetMap map(3);
  token.cancel();
  const auto cancelled = map.maximal(2, limits);
  EXPECT_EQ(cancelled.limit, LimitReason::Cancelled);
  EXPECT_TRUE(cancelled.sets.empty());
  token.reset();
  EXPECT_EQ(map.maximal(2, limits).sets.size(), 1U);
}

TEST(SubsetMap, EndsAtTheDeadline) {
  SubsetMap map(3);
  EXPECT_EQ(map.maximal(1, Limits{}.withSeconds(-1)).limit, LimitReason::Time);
  EXPECT_EQ(map.maximal(1, {}).sets.size(), 1U);
}

TEST(SubsetMap, EndsWhereItsBlocksTakeMoreThanTheLimit) {
  constexpr std::size_t kCandidates = 500;
  SubsetMap map(kCandidates);
  for (std::size_t i = 0; i < kCandidates; ++i)
    map.blockDown(CandidateSet(kCandidates).set(i));
  EXPECT_GE(map.bytes(), kCandidates * (kCandidates - 1) * sizeof(int));
  Limits limits;
  limits.bytes = map.bytes() - 1;
  const auto refineUnknown = map.maximal(1, limits);
  EXPECT_EQ(refineUnknown.limit, LimitReason::Memory);
  EXPECT_TRUE(refineUnknown.sets.empty());
  limits.bytes = 2 * map.bytes();
  EXPECT_EQ(map.maximal(1, limits).sets.size(), 1U);
}

/// More pigeons than holes, in such a way that no set is unexplored: hard for any solver of this
/// kind. Candidate p · holes + h: pigeon p sits in h.
SubsetMap pigeons(std::size_t holes) {
  const std::size_t candidates = (holes + 1) * holes;
  SubsetMap map(candidates);
  for (std::size_t p = 0; p <= holes; ++p) {
    CandidateSet seated(candidates);
    for (std::size_t h = 0; h < holes; ++h) {
      seated.set(p * holes + h);
      for (std::size_t q = 0; q < p; ++q) {
        CandidateSet both(candidates);
        map.blockUp(both.set(p * holes + h).set(q * holes + h));
      }
    }
    map.blockDown(~seated);
  }
  return map;
}

TEST(SubsetMap, ACancelEndsAHardCall) {
  SubsetMap map = pigeons(13);
  CancelToken token;
  Limits limits;
  limits.cancel = &token;
  auto result = std::async(std::launch::async, [&] { return map.maximal(1, limits).limit; });
  EXPECT_EQ(result.wait_for(std::chrono::milliseconds(300)), std::future_status::timeout)
      << "not hard enough to be cancelled";
  token.cancel();
  EXPECT_EQ(result.get(), LimitReason::Cancelled);
}

}  // namespace
}  // namespace goal_alignment::achievability
