// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/conflict_set.h"

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

RC_GTEST_PROP(ConflictSet, HoldsNoSupersetOfAProvenConflict, ()) {
  RandomSource random = oracles::anySource();
  ConflictSet conflicts;
  std::set<std::uint64_t> proven_sets;
  for (int i = 0; i < 15; ++i) {
    const std::uint64_t bits = random.below(64);
    const bool is_proven = oracles::chance(random, 0.5);
    conflicts.add(is_proven ? proven(bits) : suspected(bits));
    if (is_proven) proven_sets.insert(bits);
    for (const Conflict& a : conflicts.all()) {
      for (const Conflict& b : conflicts.all()) {
        RC_ASSERT(&a == &b || !a.proven || !a.members.is_subset_of(b.members));
        RC_ASSERT(&a == &b || b.proven || !a.members.is_subset_of(b.members));
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
  ConflictSet conflicts;
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
  ConflictSet conflicts;
  conflicts.add(suspected(0b11));
  conflicts.add(suspected(0b11));
  EXPECT_EQ(conflicts.provenWithin(setOf(0b111)), nullptr);
  EXPECT_FALSE(conflicts.all().front().proven);
}

TEST(ConflictSet, ForgetsSuspicionsThatTurnedOutWrong) {
  ConflictSet conflicts;
  conflicts.add(suspected(0b0011));
  conflicts.add(suspected(0b0110));
  conflicts.add(proven(0b1000));
  EXPECT_TRUE(conflicts.clearSuspectedWithin(setOf(0b0111)));
  EXPECT_FALSE(conflicts.clearSuspectedWithin(setOf(0b0111)));
  EXPECT_EQ(all(conflicts), std::set<std::uint64_t>{0b1000});
}

TEST(ConflictSet, LearnsThatAConflictIsMinimal) {
  ConflictSet conflicts;
  conflicts.add(proven(0b11));
  EXPECT_FALSE(conflicts.all().front().minimal);
  conflicts.add({setOf(0b11), true, true});
  EXPECT_TRUE(conflicts.all().front().minimal);
}

TEST(ConflictSet, CallsMinimalWhatHasPlansForAllButOne) {
  ConflictSet conflicts;
  conflicts.add(proven(0b0111));
  conflicts.add(proven(0b11000));
  conflicts.add(suspected(0b101000));
  const auto mark = [&](const std::set<std::uint64_t>& achievable) {
    conflicts.markMinimal(
        [&](const CandidateSet& set) { return achievable.count(set.to_ulong()) > 0; });
  };
  mark({0b011, 0b101, 0b01000, 0b10000, 0b100000});
  EXPECT_FALSE(conflicts.all()[0].minimal);  // 0b110 is open
  EXPECT_TRUE(conflicts.all()[1].minimal);
  EXPECT_FALSE(conflicts.all()[2].minimal);
  mark({0b011, 0b101, 0b110});
  EXPECT_TRUE(conflicts.all()[0].minimal);
  EXPECT_TRUE(conflicts.all()[1].minimal);  // once shown, it stays so
}

}  // namespace
}  // namespace goal_alignment::achievability
