// SPDX-License-Identifier: BSD-3-Clause
#include "questions/family_bounds.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "oracles/dialogues.h"
#include "questions/expected_cost.h"
#include "questions/family_symmetry.h"
#include "questions/outcome_entropy.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

/// The same as a situation and as a family; candidates by rising probability.
struct Sample {
  Situation situation;
  Family family;
  Chances chances;

  explicit Sample(Situation drawn) : situation(std::move(drawn)) {
    std::sort(situation.probability.begin(), situation.probability.end());
    chances = Chances(situation.probability);
    for (const auto& conflict : situation.conflicts)
      family.add(conflict.members.to_ulong());
  }
  double best() const { return oracles::BestDialogue(situation).cost(situation.knowledge); }
  double best(std::size_t first) const {
    return oracles::BestDialogue(situation).costOf(situation.knowledge, first);
  }
};

Sample anySample() {
  RandomSource random = oracles::anySource();
  return Sample(samples::anyFamily(random, 7, 10));
}

RC_GTEST_PROP(Family, HoldsMinimalSetsAndKnowsItselfInAnyOrder, ()) {
  const Sample sample = anySample();
  const std::vector<Bits> sets(sample.family.begin(), sample.family.end());
  for (const Bits a : sets) {
    for (const Bits b : sets)
      RC_ASSERT(a == b || (a & ~b) != 0);
  }
  Family backwards;
  for (auto set = sets.rbegin(); set != sets.rend(); ++set)
    backwards.add(*set);
  RC_ASSERT(backwards.key() == sample.family.key());
}

RC_GTEST_PROP(Family, AnswersLeaveWhatAddingAnewWould, ()) {
  const Sample sample = anySample();
  for (std::size_t f = 0; f < sample.situation.knowledge.size(); ++f) {
    Family yes;
    Family no;
    bool ended = false;
    for (const Bits set : sample.family) {
      ended = ended || set == bitOf(f);
      yes.add(set & ~bitOf(f));
      if ((set & bitOf(f)) == 0) no.add(set);
    }
    RC_ASSERT(sample.family.ifNotWanted(f).key() == no.key());
    RC_ASSERT(sample.family.ifWanted(f).key() == (ended ? Family() : yes).key());
  }
}

/// Up to four sets of five candidates, of which three and two are alike.
Sample anyOfLikes(RandomSource& random) {
  Situation situation = samples::fresh(5, {});
  situation.probability = {0.2, 0.2, 0.2, 0.5, 0.5};
  for (std::size_t n = oracles::between(random, 1, 4); n > 0; --n)
    situation.conflicts.push_back(samples::conflict(5, 1 + random.below(31)));
  return Sample(std::move(situation));
}

RC_GTEST_PROP(FamilySymmetry, WhatSharesAKeyCostsTheSame, ()) {
  RandomSource random = oracles::anySource();
  const Sample one = anyOfLikes(random);
  const Sample other = anyOfLikes(random);
  const bool same =
      keyUpToNames(one.family, one.chances) == keyUpToNames(other.family, other.chances);
  RC_TAG(same ? "same key" : "another key");
  if (same) RC_ASSERT(std::abs(one.best() - other.best()) < 1e-9);
}

TEST(FamilySymmetry, NamesOfLikesDontMatterOthersDo) {
  const Chances chances({0.1, 0.2, 0.2, 0.2, 0.2});
  const auto key = [&](std::vector<Bits> sets) {
    Family family;
    for (const Bits set : sets)
      family.add(set);
    return keyUpToNames(family, chances);
  };
  EXPECT_EQ(key({0b00011, 0b00110}), key({0b10001, 0b11000}));
  EXPECT_EQ(key({0b00110, 0b11000}), key({0b01010, 0b10100}));
  EXPECT_FALSE(key({0b00011, 0b00110}) == key({0b00011, 0b00101}));
  EXPECT_FALSE(key({0b00011}) == key({0b00110}));
}

RC_GTEST_PROP(FamilyBounds, LeastCostIsNeverAboveTheBest, ()) {
  const Sample sample = anySample();
  const double bound = leastCost(sample.family, sample.chances);
  RC_LOG() << bound << " against " << sample.best();
  RC_ASSERT(bound > 0);
  RC_ASSERT(bound <= sample.best() * (1 + 1e-9));
}

RC_GTEST_PROP(FamilyBounds, DisjointCostIsTheBest, ()) {
  const Sample sample = anySample();
  RC_PRE(isDisjoint(sample.family));
  RC_ASSERT(std::abs(disjointCost(sample.family, sample.chances) - sample.best()) < 1e-9);
}

RC_GTEST_PROP(FamilyBounds, WhatIsCertainlyFirstIsBest, ()) {
  const Sample sample = anySample();
  const Bits first = certainlyFirst(sample.family, sample.chances);
  RC_TAG(first != 0 ? "rule applies" : "no rule");
  for (Bits left = first; left != 0; left = withoutFirst(left))
    RC_ASSERT(sample.best(firstBit(left)) < sample.best() + 1e-8);
}

RC_GTEST_PROP(FamilyBounds, WhatIsNotWorthAskingHasBetterOrEqualInItsPlace, ()) {
  const Sample sample = anySample();
  const Bits worth = worthAsking(sample.family, sample.chances);
  double best = 1e300;
  for (Bits left = worth; left != 0; left = withoutFirst(left))
    best = std::min(best, sample.best(firstBit(left)));
  RC_ASSERT(best < sample.best() + 1e-9);
}

RC_GTEST_PROP(FamilyBounds, WhatIsAlikeCostsTheSame, ()) {
  Sample sample = anySample();
  const std::size_t f = firstBit(sample.family.all());
  const Bits same = alike(sample.family, sample.chances, f);
  RC_ASSERT((same & bitOf(f)) != 0);
  for (Bits left = same; left != 0; left = withoutFirst(left))
    RC_ASSERT(std::abs(sample.best(firstBit(left)) - sample.best(f)) < 1e-9);
}

RC_GTEST_PROP(ExpectedCost, IsThatOfTheBestDialogue, ()) {
  const Sample sample = anySample();
  ExpectedCost cost(sample.chances);
  const auto found = cost.of(sample.family, 1'000'000'000);
  RC_ASSERT(std::abs(found.value() - sample.best()) < 1e-9 * std::max(1.0, sample.best()));
}

double exactChanceOfNo(const Sample& sample) {
  const std::size_t n = sample.situation.knowledge.size();
  double no = 0;
  for (Bits wanted = 0; wanted < Bits{1} << n; ++wanted) {
    if (std::any_of(sample.family.begin(), sample.family.end(),
                    [wanted](Bits set) { return (set & ~wanted) == 0; })) {
      continue;
    }
    double chance = 1;
    for (std::size_t f = 0; f < n; ++f) {
      const double p = sample.chances[f];
      chance *= (wanted & bitOf(f)) != 0 ? p : 1 - p;
    }
    no += chance;
  }
  return no;
}

RC_GTEST_PROP(OutcomeEntropy, ChanceOfNoIsNeverTooHigh, ()) {
  const Sample sample = anySample();
  const double chance = chanceOfNo(sample.family, sample.chances);
  RC_ASSERT(chance >= 0);
  RC_ASSERT(chance <= exactChanceOfNo(sample) + 1e-9);
  if (isDisjoint(sample.family)) RC_ASSERT(chance >= exactChanceOfNo(sample) - 1e-9);
}

TEST(OutcomeEntropy, SeesWhatIsSharedHoweverUnlikely) {
  Family star;
  for (std::size_t arm = 1; arm < 10; ++arm)
    star.add(bitOf(0) | bitOf(arm));
  for (const double p : {1e-100, 1e-10, 0.1})
    EXPECT_EQ(leavingLeastDoubt(star, Chances(std::vector<double>(10, p))), bitOf(0)) << p;
}

TEST(OutcomeEntropy, WithoutDoubtNothingIsToBeLearnt) {
  Family family;
  family.add(0b011);
  family.add(0b110);
  EXPECT_EQ(leavingLeastDoubt(family, Chances({0, 0, 0})), 0U);
  EXPECT_EQ(leavingLeastDoubt(family, Chances({1, 1, 1})), 0U);
  EXPECT_NE(leavingLeastDoubt(family, Chances({0, 0.5, 1})), 0U);
}

}  // namespace
}  // namespace goal_alignment::questions
