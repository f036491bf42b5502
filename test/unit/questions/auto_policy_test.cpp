// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "goal_alignment/questions/policy.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using achievability::Conflict;
using samples::conflict;
using samples::fresh;

std::optional<Choice> firstOf(const Situation& situation, std::uint64_t seed = 0) {
  Setting setting;
  setting.seed = seed;
  return makePolicy("auto", setting)->next(situation);
}

RC_GTEST_PROP(AutoPolicy, AsksAnOpenFluentOfASmallestLiveConflict, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anySituation(random);
  const auto choice = firstOf(situation, random.below(10));
  const auto askable = [&](const Conflict& known) {
    return situation.isLive(known) && situation.openMembers(known) > 0;
  };
  const bool any = std::any_of(situation.conflicts.begin(), situation.conflicts.end(), askable);
  RC_ASSERT(choice.has_value() == any);
  if (!choice) return;
  const Conflict& asked = situation.conflicts.at(choice->conflict.value());
  RC_ASSERT(askable(asked));
  RC_ASSERT(asked.members.test(choice->candidate));
  RC_ASSERT(situation.knowledge[choice->candidate] == Knowledge::Open);
  for (const Conflict& other : situation.conflicts) {
    if (!askable(other)) continue;
    RC_ASSERT(asked.proven || !other.proven);
    if (asked.proven == other.proven) {
      RC_ASSERT(situation.openMembers(asked) <= situation.openMembers(other));
    }
  }
  for (const std::size_t f : achievability::members(asked.members)) {
    if (situation.knowledge[f] != Knowledge::Open) continue;
    RC_ASSERT(situation.probability[choice->candidate] <= situation.probability[f]);
  }
}

TEST(AutoPolicy, AmongEquallyUnlikelyOnesAsksTheOneInMostLiveConflicts) {
  Situation situation = fresh(4, {conflict(4, 0b0011), conflict(4, 0b0110), conflict(4, 0b1010)});
  EXPECT_EQ(firstOf(situation)->candidate, 1U);
  situation.probability[0] = 0.2;
  EXPECT_EQ(firstOf(situation)->candidate, 0U);
}

TEST(AutoPolicy, BreaksTiesByTheSeed) {
  const Situation situation = fresh(4, {conflict(4, 0b1111)});
  std::set<std::size_t> asked;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    asked.insert(firstOf(situation, seed)->candidate);
    EXPECT_EQ(firstOf(situation, seed)->candidate, firstOf(situation, seed)->candidate);
  }
  EXPECT_EQ(asked.size(), 4U);
}

TEST(AutoPolicy, HasNothingToAskWhereNoConflictIsOpen) {
  Situation situation = fresh(3, {conflict(3, 0b011)});
  situation.knowledge[0] = Knowledge::Wanted;
  situation.knowledge[1] = Knowledge::Unsure;
  EXPECT_FALSE(firstOf(situation).has_value());
  EXPECT_FALSE(firstOf(fresh(3, {})).has_value());
}

}  // namespace
}  // namespace goal_alignment::questions
