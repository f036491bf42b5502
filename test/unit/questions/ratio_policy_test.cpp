// SPDX-License-Identifier: BSD-3-Clause
#include "questions/ratio_policy.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators/conflict_families.h"
#include "oracles/dialogues.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using benchmarks::expectedQuestions;
using samples::conflict;
using samples::fresh;
using samples::policyOf;

RC_GTEST_PROP(RatioPolicy, IsOptimalWhereConflictsShareNothing, ()) {
  RandomSource random = oracles::anySource();
  const double least_likely = random.unit();
  const Situation situation = benchmarks::conflictFamily("disjoint", oracles::between(random, 1, 8),
                                                         0, 0, least_likely, random);
  const double least = oracles::BestDialogue(situation).cost(situation.knowledge);
  const double found = expectedQuestions(*policyOf("ratio", random.below(10)), situation);
  RC_LOG() << found << " instead of " << least;
  RC_ASSERT(std::abs(found - least) < 1e-9 * std::max(1.0, least));
}

RC_GTEST_PROP(RatioPolicy, IsNeverBetterThanAutoOnFewConflicts, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anyUnanswered(random, 8);
  RC_ASSERT(expectedQuestions(*policyOf("auto"), situation) <=
            expectedQuestions(*policyOf("ratio"), situation) + 1e-9);
}

TEST(RatioPolicy, AmongEquallyUnlikelyOnesAsksTheOneInMostLiveConflicts) {
  Situation situation = fresh(4, {conflict(4, 0b0011), conflict(4, 0b0110), conflict(4, 0b1010)});
  EXPECT_EQ(policyOf("ratio")->next(situation)->candidate, 1U);
  situation.probability[0] = 0.2;
  EXPECT_NE(policyOf("ratio")->next(situation)->candidate, 0U);
}

TEST(RatioPolicy, WeighsHowLikelyAConflictIsAgainstWhatItTakes) {
  // 0.64/1.8 against 0.3/1 and 0.9/1.
  Situation situation = fresh(4, {conflict(4, 0b0011), conflict(4, 0b0100)});
  situation.probability = {0.8, 0.8, 0.3, 0.9};
  EXPECT_NE(policyOf("ratio")->next(situation)->candidate, 2U);
  situation.conflicts.push_back(conflict(4, 0b1000));
  EXPECT_EQ(policyOf("ratio")->next(situation)->candidate, 3U);
}

}  // namespace
}  // namespace goal_alignment::questions
