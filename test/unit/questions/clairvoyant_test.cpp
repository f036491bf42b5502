// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/clairvoyant.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "oracles/dialogues.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using achievability::CandidateSet;
using samples::conflict;
using samples::fresh;

TEST(ClairvoyantMinimum, IsTheSmallestConflictThatIsWanted) {
  const Situation situation = fresh(5, {conflict(5, 0b00111), conflict(5, 0b11000)});
  EXPECT_EQ(clairvoyantMinimum(situation.conflicts, CandidateSet(5, 0b11111)), 2U);
  EXPECT_EQ(clairvoyantMinimum(situation.conflicts, CandidateSet(5, 0b00111)), 3U);
}

TEST(ClairvoyantMinimum, IsOtherwiseTheSmallestHittingSetOfWhatIsNotWanted) {
  const Situation star = fresh(4, {conflict(4, 0b0011), conflict(4, 0b0101), conflict(4, 0b1001)});
  EXPECT_EQ(clairvoyantMinimum(star.conflicts, CandidateSet(4, 0b0000)), 1U);
  EXPECT_EQ(clairvoyantMinimum(star.conflicts, CandidateSet(4, 0b0001)), 3U);
}

TEST(ClairvoyantMinimum, IsNothingWhereNothingIsInConflictOrTheGoalItselfIs) {
  EXPECT_EQ(clairvoyantMinimum({}, CandidateSet(3, 0b111)), 0U);
  EXPECT_EQ(clairvoyantMinimum({conflict(3, 0)}, CandidateSet(3, 0b111)), 0U);
}

/// The fewest answers that end the dialogue, over all sets of candidates answered truly.
std::size_t byBruteForce(Situation situation, const CandidateSet& wanted) {
  const std::size_t n = wanted.size();
  std::size_t fewest = n;
  for (std::uint64_t asked = 0; asked < std::uint64_t{1} << n; ++asked) {
    const CandidateSet set(n, asked);
    for (std::size_t f = 0; f < n; ++f) {
      situation.knowledge[f] = !set.test(f)     ? Knowledge::Open
                               : wanted.test(f) ? Knowledge::Wanted
                                                : Knowledge::NotWanted;
    }
    if (oracles::hasEnded(situation)) fewest = std::min(fewest, set.count());
  }
  return fewest;
}

RC_GTEST_PROP(ClairvoyantMinimum, EqualsBruteForce, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anyUnanswered(random, 9, 12);
  const std::size_t n = situation.knowledge.size();
  const CandidateSet wanted(n, random.below(std::size_t{1} << n));
  RC_ASSERT(clairvoyantMinimum(situation.conflicts, wanted) == byBruteForce(situation, wanted));
}

TEST(ClairvoyantMinimum, ManagesFortyCandidatesInTwoHundredConflicts) {
  RandomSource random(1);
  std::vector<achievability::Conflict> conflicts;
  for (int i = 0; i < 200; ++i) {
    achievability::Conflict each = conflict(40, 0);
    while (each.members.count() < 3)
      each.members.set(random.below(40));
    conflicts.push_back(each);
  }
  const std::size_t minimum = clairvoyantMinimum(conflicts, CandidateSet(40));
  EXPECT_GE(minimum, 10U);
  EXPECT_LE(minimum, 30U);
}

}  // namespace
}  // namespace goal_alignment::questions
