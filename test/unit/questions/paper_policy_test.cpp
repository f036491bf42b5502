// SPDX-License-Identifier: BSD-3-Clause
#include "questions/paper_policy.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "oracles/algorithm_one.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using samples::askedAll;
using samples::conflict;
using samples::fresh;

// Replayed by hand. F̂ = {0, 1}, p = (0.5, 0.2, 0.3):
//   V(0) = 0.5·1 + 0.5·0.2, V(1) = 0.2·1 + 0.8·0.5, V(2) = 0.3·(0.5·0.2) + 0.7·(0.5·0.2)
TEST(ValueOfQuery, WithUnachievableFluents) {
  const std::vector<double> value = valueOfQuery({0.5, 0.2, 0.3}, {true, true, false});
  EXPECT_NEAR(value[0], 0.6, 1e-12);
  EXPECT_NEAR(value[1], 0.6, 1e-12);
  EXPECT_NEAR(value[2], 0.1, 1e-12);
}

TEST(ValueOfQuery, ASingleUnachievableFluentIsCertainlyWorthAsking) {
  const std::vector<double> value = valueOfQuery({0.3, 0.7}, {true, false});
  EXPECT_NEAR(value[0], 1, 1e-12);  // 0.3·1 + 0.7·(empty product)
  EXPECT_NEAR(value[1], 0.3, 1e-12);
}

// An empty product is 1: every question is worth the same, whatever the beliefs.
TEST(ValueOfQuery, IsOneForAllWhereEverythingIsAchievable) {
  for (const double value : valueOfQuery({0.1, 0.5, 0.9}, {false, false, false})) {
    EXPECT_NEAR(value, 1, 1e-12);
  }
  EXPECT_TRUE(valueOfQuery({}, {}).empty());
}

struct Drawn {
  std::vector<double> belief;
  std::vector<bool> unachievable;
};

Drawn draw(RandomSource& random) {
  Drawn drawn;
  for (std::size_t n = oracles::between(random, 1, 8); n > 0; --n) {
    drawn.belief.push_back(static_cast<double>(1 + random.below(4)) / 5);
    drawn.unachievable.push_back(oracles::chance(random, 0.3));
  }
  return drawn;
}

PolicyContext contextOf(const Drawn& drawn, std::uint64_t seed) {
  PolicyContext context;
  context.is_static.assign(drawn.belief.size(), false);
  context.seed = seed;
  context.paper_beliefs = [drawn] { return drawn.belief; };
  context.unachievable_alone = [drawn] { return drawn.unachievable; };
  return context;
}

RC_GTEST_PROP(ValueOfQuery, EqualsThePrintedFormula, ()) {
  RandomSource random = oracles::anySource();
  const Drawn drawn = draw(random);
  const auto found = valueOfQuery(drawn.belief, drawn.unachievable);
  const auto expected = oracles::valueOfQuery(drawn.belief, drawn.unachievable);
  for (std::size_t f = 0; f < found.size(); ++f) {
    RC_ASSERT(std::abs(found[f] - expected[f]) < 1e-12);
  }
}

RC_GTEST_PROP(PaperPolicy, AsksEverythingOnceByFallingValue, ()) {
  RandomSource random = oracles::anySource();
  const Drawn drawn = draw(random);
  PaperPolicy policy(contextOf(drawn, random.below(100)));
  const std::vector<std::size_t> asked =
      askedAll(policy, fresh(drawn.belief.size(), {}), Knowledge::Wanted);
  RC_ASSERT(std::set<std::size_t>(asked.begin(), asked.end()).size() == drawn.belief.size());
  RC_ASSERT(asked.size() == drawn.belief.size());
  const auto value = oracles::valueOfQuery(drawn.belief, drawn.unachievable);
  for (std::size_t i = 1; i < asked.size(); ++i) {
    RC_ASSERT(value[asked[i - 1]] > value[asked[i]] - 1e-8);
  }
}

TEST(PaperPolicy, BreaksTiesUniformlyByTheSeed) {
  const Drawn drawn = {{0.5, 0.2, 0.3}, {false, false, false}};
  std::set<std::vector<std::size_t>> orders;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    PaperPolicy policy(contextOf(drawn, seed));
    PaperPolicy again(contextOf(drawn, seed));
    const auto asked = askedAll(policy, fresh(3, {}), Knowledge::Wanted);
    EXPECT_EQ(askedAll(again, fresh(3, {}), Knowledge::Wanted), asked);
    orders.insert(asked);
  }
  EXPECT_EQ(orders.size(), 6U);
}

// 0.1·3 and 0.3 differ in the last bit: that must not decide who is asked first.
TEST(PaperPolicy, ValuesThatDifferByRoundingAloneAreTies) {
  const Drawn drawn = {{0.1 + 0.2, 0.3, 0.5}, {true, true, false}};
  std::set<std::size_t> first;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    PaperPolicy policy(contextOf(drawn, seed));
    first.insert(policy.next(fresh(3, {}))->candidate);
  }
  EXPECT_EQ(first, (std::set<std::size_t>{0, 1}));
}

TEST(PaperPolicy, AsksStaticFluentsUnlessToldNotTo) {
  const Drawn drawn = {{0.5, 0.5, 0.5}, {false, true, false}};
  PolicyContext context = contextOf(drawn, 1);
  context.is_static = {true, false, true};
  PaperPolicy with(context);
  EXPECT_EQ(askedAll(with, fresh(3, {}), Knowledge::Wanted).size(), 3U);
  context.ask_static = false;
  PaperPolicy without(context);
  EXPECT_EQ(askedAll(without, fresh(3, {}), Knowledge::Wanted), std::vector<std::size_t>{1});
}

TEST(PaperPolicy, NeedsNoBeliefsWhereTheyCannotMatter) {
  PolicyContext context = contextOf({{0.5, 0.5}, {false, false}}, 0);
  context.paper_beliefs = []() -> std::vector<double> {
    ADD_FAILURE() << "with an empty F̂ every value is 1";
    return {0.5, 0.5};
  };
  PaperPolicy policy(context);
  EXPECT_TRUE(policy.next(fresh(2, {})).has_value());
}

TEST(PaperPolicy, SkipsWhatWasVolunteeredAndNamesALiveConflict) {
  PaperPolicy policy(contextOf({{0.5, 0.5, 0.5}, {true, false, false}}, 0));
  Situation situation = fresh(3, {conflict(3, 0b011)});
  EXPECT_EQ(policy.next(situation)->candidate, 0U);
  EXPECT_EQ(policy.next(situation)->conflict, 0U);
  situation.knowledge[0] = Knowledge::NotWanted;
  const auto next = policy.next(situation);
  EXPECT_NE(next->candidate, 0U);
  EXPECT_EQ(next->conflict, std::nullopt);
}

// "Don't know" may become open once more (unsure policy `defer`): the policy asks it again.
TEST(PaperPolicy, AsksAgainWhatBecomesOpenAgain) {
  PaperPolicy policy(contextOf({{0.5, 0.5}, {true, false}}, 0));
  Situation situation = fresh(2, {});
  situation.knowledge[0] = Knowledge::Unsure;
  EXPECT_EQ(policy.next(situation)->candidate, 1U);
  situation.knowledge[1] = Knowledge::Wanted;
  EXPECT_FALSE(policy.next(situation).has_value());
  situation.knowledge[0] = Knowledge::Open;
  ASSERT_TRUE(policy.next(situation).has_value());
  EXPECT_EQ(policy.next(situation)->candidate, 0U);
}

}  // namespace
}  // namespace goal_alignment::questions
