// SPDX-License-Identifier: BSD-3-Clause
// What `auto`, `optimal` and `ratio` have in common.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>
#include <string>

#include "goal_alignment/questions/policy.h"
#include "oracles/dialogues.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using achievability::Conflict;
using samples::conflict;
using samples::fresh;
using samples::policyOf;

class ConflictPolicies : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(, ConflictPolicies, testing::Values("auto", "optimal", "ratio"),
                         [](const auto& each) { return each.param; });

TEST_P(ConflictPolicies, AskOpenFluentsOfLiveConflictsUntilTheEnd) {
  EXPECT_TRUE(rc::check([&] {
    RandomSource random = oracles::anySource();
    const Situation situation = samples::anySituation(random);
    const auto choice = policyOf(GetParam(), random.below(10))->next(situation);
    RC_ASSERT(choice.has_value() == !oracles::hasEnded(situation));
    if (!choice) return;
    RC_ASSERT(situation.knowledge[choice->candidate] == Knowledge::Open);
    const Conflict& reason = situation.conflicts.at(choice->conflict.value());
    RC_ASSERT(situation.isLive(reason));
    RC_ASSERT(reason.members.test(choice->candidate));
  }));
}

TEST_P(ConflictPolicies, AreCertainOfNothing) {
  for (const double p : {0.0, 1e-300, 1 - 1e-16, 1.0}) {
    Situation situation =
        fresh(5, {conflict(5, 0b00111), conflict(5, 0b01100), conflict(5, 0b10001)});
    situation.probability.assign(5, p);
    const auto policy = policyOf(GetParam());
    for (const Knowledge answer : {Knowledge::Wanted, Knowledge::NotWanted, Knowledge::Unsure}) {
      const auto asked = samples::askedAll(*policy, situation, answer);
      EXPECT_EQ(std::set<std::size_t>(asked.begin(), asked.end()).size(), asked.size());
      EXPECT_GE(asked.size(), 2U);
    }
  }
}

TEST_P(ConflictPolicies, ManySmallProbabilitiesDoNotUnderflow) {
  Situation situation = fresh(60, {});
  situation.probability.assign(60, 1e-300);
  situation.conflicts = {conflict(60, 0b111), conflict(60, (std::uint64_t{1} << 60U) - 8)};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto choice = policyOf(GetParam(), seed)->next(situation);
    ASSERT_TRUE(choice.has_value());
  }
}

TEST_P(ConflictPolicies, ReachTiesUniformlyOverTheSeeds) {
  const Situation situation = fresh(4, {conflict(4, 0b1111)});
  std::map<std::size_t, int> asked;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    ++asked[policyOf(GetParam(), seed)->next(situation)->candidate];
    EXPECT_EQ(policyOf(GetParam(), seed)->next(situation)->candidate,
              policyOf(GetParam(), seed)->next(situation)->candidate);
  }
  for (std::size_t f = 0; f < 4; ++f)
    EXPECT_NEAR(asked[f], 100, 40) << f;
}

TEST_P(ConflictPolicies, PreferAmongEqualsAReasonThatIsProven) {
  const Situation situation =
      fresh(6, {conflict(6, 0b000011, false), conflict(6, 0b001100), conflict(6, 0b110000, false)});
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    EXPECT_EQ(policyOf(GetParam(), seed)->next(situation)->conflict, 1U);
}

// An answer of "don't know" leaves a conflict alive: it counts as a YES that proves nothing.
TEST_P(ConflictPolicies, TakeUnsureForNotANo) {
  EXPECT_TRUE(rc::check([&] {
    RandomSource random = oracles::anySource();
    Situation situation = samples::anySituation(random);
    const std::uint64_t seed = random.below(10);
    const auto unsure = policyOf(GetParam(), seed)->next(situation);
    for (Knowledge& each : situation.knowledge) {
      if (each == Knowledge::Unsure) each = Knowledge::Wanted;
    }
    const auto wanted = policyOf(GetParam(), seed)->next(situation);
    RC_ASSERT(unsure.has_value() == wanted.has_value());
    if (unsure) RC_ASSERT(unsure->candidate == wanted->candidate);
  }));
}

}  // namespace
}  // namespace goal_alignment::questions
