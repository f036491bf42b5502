// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/conflict_set.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "oracles/seeds.h"

namespace goal_alignment::achievability {
namespace {

constexpr std::size_t kCandidates = 6;

CandidateSet setOf(std::uint64_t bits) {
  return CandidateSet(kCandidates, bits);
}

Conflict proven(std::uint64_t bits) {
  return {setOf(bits), true, false};
}
Conflict suspected(std::uint64_t bits) {
  return {setOf(bits), false, false};
}

std::set<std::uint64_t> all(const ConflictSet& conflicts) {
  std::set<std::uint64_t> sets;
  for (const Conflict& conflict : conflicts.all())
    sets.insert(conflict.members.to_ulong());
  return sets;
}

/// The minimal sets that hit every conflict, by trying all sets.
std::set<std::uint64_t> hittingSets(const ConflictSet& conflicts) {
  const auto hits = [&](std::uint64_t bits) {
    return std::all_of(conflicts.all().begin(), conflicts.all().end(),
                       [&](const Conflict& c) { return (c.members.to_ulong() & bits) != 0; });
  };
  std::set<std::uint64_t> minimal;
  for (std::uint64_t bits = 0; bits < 1U << kCandidates; ++bits) {
    bool is_minimal = hits(bits);
    for (std::size_t f = 0; f < kCandidates; ++f) {
      const std::uint64_t without = bits & ~(std::uint64_t{1} << f);
      if (without != bits && hits(without)) is_minimal = false;
    }
    if (is_minimal) minimal.insert(bits);
  }
  return minimal;
}

std::set<std::uint64_t> found(ConflictSet& conflicts) {
  std::set<std::uint64_t> sets;
  for (const CandidateSet& set : *conflicts.minimalHittingSets(1000))
    sets.insert(set.to_ulong());
  return sets;
}

// Asked after every change, since the hitting sets are kept up to date step by step.
RC_GTEST_PROP(ConflictSet, HittingSetsEqualBruteForceAfterEveryChange, ()) {
  RandomSource random = oracles::anySource();
  ConflictSet conflicts(kCandidates);
  RC_ASSERT(found(conflicts) == std::set<std::uint64_t>{0});
  for (int i = 0; i < 12; ++i) {
    const std::uint64_t bits = 1 + random.below(63);
    switch (random.below(4)) {
      case 0:
        conflicts.add(suspected(bits));
        break;
      case 1:
        conflicts.clearSuspectedWithin(setOf(bits));
        break;
      default:
        conflicts.add(proven(bits));
    }
    RC_ASSERT(found(conflicts) == hittingSets(conflicts));
  }
}

RC_GTEST_PROP(ConflictSet, HoldsNoSupersetOfAProvenConflict, ()) {
  RandomSource random = oracles::anySource();
  ConflictSet conflicts(kCandidates);
  std::set<std::uint64_t> proven_sets;
  for (int i = 0; i < 15; ++i) {
    const std::uint64_t bits = random.below(64);
    const bool is_proven = oracles::chance(random, 0.5);
    conflicts.add(is_proven ? proven(bits) : suspected(bits));
    if (is_proven) proven_sets.insert(bits);
    for (const Conflict& a : conflicts.all()) {
      for (const Conflict& b : conflicts.all()) {
        RC_ASSERT(&a == &b || !a.proven || !a.members.is_subset_of(b.members));
      }
    }
    for (std::uint64_t set = 0; set < 64; ++set) {
      const bool expected =
          std::any_of(proven_sets.begin(), proven_sets.end(),
                      [&](std::uint64_t conflict) { return (conflict & ~set) == 0; });
      const Conflict* within = conflicts.provenWithin(setOf(set));
      RC_ASSERT((within != nullptr) == expected);
      if (within != nullptr) RC_ASSERT(within->proven && within->members.is_subset_of(setOf(set)));
    }
  }
}

TEST(ConflictSet, AddSaysWhetherThatIsNews) {
  ConflictSet conflicts(kCandidates);
  EXPECT_TRUE(conflicts.add(suspected(0b110)));
  EXPECT_FALSE(conflicts.add(suspected(0b110)));
  EXPECT_TRUE(conflicts.add(proven(0b110)));
  EXPECT_FALSE(conflicts.add(proven(0b110)));
  EXPECT_FALSE(conflicts.add(suspected(0b110)));
  EXPECT_FALSE(conflicts.add(proven(0b111)));
  EXPECT_TRUE(conflicts.add(proven(0b100)));
  EXPECT_EQ(all(conflicts), std::set<std::uint64_t>{0b100});
  EXPECT_TRUE(conflicts.all().front().proven);
}

TEST(ConflictSet, ASuspicionNeverBecomesAProof) {
  ConflictSet conflicts(kCandidates);
  conflicts.add(suspected(0b11));
  conflicts.add(suspected(0b11));
  EXPECT_EQ(conflicts.provenWithin(setOf(0b111)), nullptr);
  EXPECT_FALSE(conflicts.all().front().proven);
}

TEST(ConflictSet, ForgetsSuspicionsThatTurnedOutWrong) {
  ConflictSet conflicts(kCandidates);
  conflicts.add(suspected(0b0011));
  conflicts.add(suspected(0b0110));
  conflicts.add(proven(0b1000));
  conflicts.clearSuspectedWithin(setOf(0b0111));
  EXPECT_EQ(all(conflicts), std::set<std::uint64_t>{0b1000});
}

TEST(ConflictSet, LearnsThatAConflictIsMinimal) {
  ConflictSet conflicts(kCandidates);
  conflicts.add(proven(0b11));
  EXPECT_FALSE(conflicts.all().front().minimal);
  conflicts.add({setOf(0b11), true, true});
  EXPECT_TRUE(conflicts.all().front().minimal);
}

TEST(ConflictSet, NothingHitsTheEmptyConflict) {
  ConflictSet conflicts(kCandidates);
  conflicts.add(proven(0));
  EXPECT_TRUE(found(conflicts).empty());
}

// n disjoint pairs have 2^n minimal hitting sets.
TEST(ConflictSet, GivesUpBeyondSoManyHittingSets) {
  ConflictSet conflicts(40);
  for (std::size_t i = 0; i < 20; ++i) {
    Conflict conflict;
    conflict.members.resize(40);
    conflict.members.set(2 * i);
    conflict.members.set(2 * i + 1);
    conflicts.add(conflict);
  }
  EXPECT_EQ(conflicts.minimalHittingSets(5000), nullptr);
  EXPECT_EQ(conflicts.minimalHittingSets(5000), nullptr);  // and again
}

}  // namespace
}  // namespace goal_alignment::achievability
