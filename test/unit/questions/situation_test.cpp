// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "goal_alignment/questions/policy.h"
#include "questions/live_conflict.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using samples::conflict;
using samples::fresh;

TEST(Situation, AConflictLivesUntilSomeFluentOfItIsNotWanted) {
  Situation situation = fresh(4, {conflict(4, 0b0011)});
  const auto& both = situation.conflicts.front();
  EXPECT_TRUE(situation.isLive(both));
  EXPECT_EQ(situation.openMembers(both), 2U);
  situation.knowledge[0] = Knowledge::Wanted;
  situation.knowledge[1] = Knowledge::Unsure;
  situation.knowledge[2] = Knowledge::NotWanted;
  EXPECT_TRUE(situation.isLive(both));
  EXPECT_EQ(situation.openMembers(both), 0U);
  situation.knowledge[1] = Knowledge::NotWanted;
  EXPECT_FALSE(situation.isLive(both));
}

TEST(SmallestLiveConflict, PrefersProvenOnesThenFewOpenFluents) {
  Situation situation =
      fresh(5, {conflict(5, 0b00001, false), conflict(5, 0b01111), conflict(5, 0b10011)});
  EXPECT_EQ(smallestLiveConflict(situation, 0), 2U);
  situation.knowledge[2] = Knowledge::Wanted;
  situation.knowledge[3] = Knowledge::Wanted;
  EXPECT_EQ(smallestLiveConflict(situation, 0), 1U);
  situation.knowledge[1] = Knowledge::NotWanted;
  EXPECT_EQ(smallestLiveConflict(situation, 0), 0U);
  EXPECT_EQ(smallestLiveConflict(situation, 4), std::nullopt);
}

RC_GTEST_PROP(SmallestLiveConflict, IsLiveAndHoldsTheCandidate, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anySituation(random);
  const std::size_t candidate = random.below(situation.knowledge.size());
  const auto found = smallestLiveConflict(situation, candidate);
  bool any = false;
  for (const auto& known : situation.conflicts) {
    any = any || (situation.isLive(known) && known.members.test(candidate));
  }
  RC_ASSERT(found.has_value() == any);
  if (!found) return;
  RC_ASSERT(situation.isLive(situation.conflicts[*found]));
  RC_ASSERT(situation.conflicts[*found].members.test(candidate));
}

}  // namespace
}  // namespace goal_alignment::questions
