// SPDX-License-Identifier: BSD-3-Clause
#include "questions/dnf_bounds.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "oracles/dialogues.h"
#include "questions/dnf_symmetry.h"
#include "questions/expected_cost.h"
#include "questions/outcome_entropy.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

/// The same as a situation and as a dnf; candidates by rising probability.
struct Sample {
  Situation situation;
  MonotoneDnf dnf;
  Chances chances;

  explicit Sample(Situation drawn) : situation(std::move(drawn)) {
    std::sort(situation.probability.begin(), situation.probability.end());
    chances = Chances(situation.probability);
    for (const auto& conflict : situation.conflicts)
      dnf.add(conflict.members.to_ulong());
  }
  double best() const { return oracles::BestDialogue(situation).cost(situation.knowledge); }
  double best(std::size_t first) const {
    return oracles::BestDialogue(situation).costOf(situation.knowledge, first);
  }
};

Sample anySample() {
  RandomSource random = oracles::anySource();
  return Sample(samples::anyUnanswered(random, 7, 10));
}

RC_GTEST_PROP(MonotoneDnf, HoldsMinimalSetsAndKnowsItselfInAnyOrder, ()) {
  const Sample sample = anySample();
  const std::vector<CandidateMask> sets(sample.dnf.begin(), sample.dnf.end());
  for (const CandidateMask a : sets) {
    for (const CandidateMask b : sets)
      RC_ASSERT(a == b || (a & ~b) != 0);
  }
  MonotoneDnf backwards;
  for (auto set = sets.rbegin(); set != sets.rend(); ++set)
    backwards.add(*set);
  RC_ASSERT(backwards.key() == sample.dnf.key());
}

RC_GTEST_PROP(MonotoneDnf, AnswersLeaveWhatAddingAnewWould, ()) {
  const Sample sample = anySample();
  for (std::size_t f = 0; f < sample.situation.knowledge.size(); ++f) {
    MonotoneDnf yes;
    MonotoneDnf no;
    bool ended = false;
    for (const CandidateMask set : sample.dnf) {
      ended = ended || set == maskOf(f);
      yes.add(set & ~maskOf(f));
      if ((set & maskOf(f)) == 0) no.add(set);
    }
    RC_ASSERT(sample.dnf.ifNotWanted(f).key() == no.key());
    RC_ASSERT(sample.dnf.ifWanted(f).key() == (ended ? MonotoneDnf() : yes).key());
  }
}

/// Up to four sets of five candidates, of which three and two are equally likely.
Sample anyOfEquallyLikely(RandomSource& random) {
  Situation situation = samples::fresh(5, {});
  situation.probability = {0.2, 0.2, 0.2, 0.5, 0.5};
  for (std::size_t n = oracles::between(random, 1, 4); n > 0; --n)
    situation.conflicts.push_back(samples::conflict(5, 1 + random.below(31)));
  return Sample(std::move(situation));
}

RC_GTEST_PROP(DnfSymmetry, WhatSharesAKeyCostsTheSame, ()) {
  RandomSource random = oracles::anySource();
  const Sample one = anyOfEquallyLikely(random);
  const Sample other = anyOfEquallyLikely(random);
  const bool same =
      keyUpToRenaming(one.dnf, one.chances) == keyUpToRenaming(other.dnf, other.chances);
  RC_TAG(same ? "same key" : "another key");
  if (same) RC_ASSERT(std::abs(one.best() - other.best()) < 1e-9);
}

TEST(DnfSymmetry, OnlyTheNamesOfEquallyLikelyCandidatesDontMatter) {
  const Chances chances({0.1, 0.2, 0.2, 0.2, 0.2});
  const auto key = [&](std::vector<CandidateMask> sets) {
    MonotoneDnf dnf;
    for (const CandidateMask set : sets)
      dnf.add(set);
    return keyUpToRenaming(dnf, chances);
  };
  EXPECT_EQ(key({0b00011, 0b00110}), key({0b10001, 0b11000}));
  EXPECT_EQ(key({0b00110, 0b11000}), key({0b01010, 0b10100}));
  EXPECT_FALSE(key({0b00011, 0b00110}) == key({0b00011, 0b00101}));
  EXPECT_FALSE(key({0b00011}) == key({0b00110}));
}

RC_GTEST_PROP(DnfBounds, TheLowerBoundIsNeverAboveTheBest, ()) {
  const Sample sample = anySample();
  const double bound = costLowerBound(sample.dnf, sample.chances);
  RC_LOG() << bound << " against " << sample.best();
  RC_ASSERT(bound > 0);
  RC_ASSERT(bound <= sample.best() * (1 + 1e-9));
}

RC_GTEST_PROP(DnfBounds, DisjointCostIsTheBest, ()) {
  const Sample sample = anySample();
  RC_PRE(isDisjoint(sample.dnf));
  RC_ASSERT(std::abs(disjointCost(sample.dnf, sample.chances) - sample.best()) < 1e-9);
}

RC_GTEST_PROP(DnfBounds, WhatIsProvablyBestFirstIsBest, ()) {
  const Sample sample = anySample();
  const CandidateMask first = provablyBestFirst(sample.dnf, sample.chances);
  RC_TAG(first != 0 ? "rule applies" : "no rule");
  for (CandidateMask left = first; left != 0; left = clearLowestBit(left))
    RC_ASSERT(sample.best(firstCandidate(left)) < sample.best() + 1e-8);
}

RC_GTEST_PROP(DnfBounds, AnUndominatedCandidateIsAmongTheBest, ()) {
  const Sample sample = anySample();
  const CandidateMask worth = undominatedCandidates(sample.dnf, sample.chances);
  double best = 1e300;
  for (CandidateMask left = worth; left != 0; left = clearLowestBit(left))
    best = std::min(best, sample.best(firstCandidate(left)));
  RC_ASSERT(best < sample.best() + 1e-9);
}

RC_GTEST_PROP(DnfBounds, EquivalentCandidatesCostTheSame, ()) {
  Sample sample = anySample();
  const std::size_t f = firstCandidate(sample.dnf.all());
  const CandidateMask same = equivalentCandidates(sample.dnf, sample.chances, f);
  RC_ASSERT((same & maskOf(f)) != 0);
  for (CandidateMask left = same; left != 0; left = clearLowestBit(left))
    RC_ASSERT(std::abs(sample.best(firstCandidate(left)) - sample.best(f)) < 1e-9);
}

RC_GTEST_PROP(ExpectedCost, IsThatOfTheBestDialogue, ()) {
  const Sample sample = anySample();
  ExpectedCost cost(sample.chances);
  const auto found = cost.of(sample.dnf, 1'000'000'000);
  RC_ASSERT(std::abs(found.value() - sample.best()) < 1e-9 * std::max(1.0, sample.best()));
}

double exactChanceOfNo(const Sample& sample) {
  const std::size_t n = sample.situation.knowledge.size();
  double no = 0;
  for (CandidateMask wanted = 0; wanted < CandidateMask{1} << n; ++wanted) {
    if (std::any_of(sample.dnf.begin(), sample.dnf.end(),
                    [wanted](CandidateMask set) { return (set & ~wanted) == 0; })) {
      continue;
    }
    double chance = 1;
    for (std::size_t f = 0; f < n; ++f) {
      const double p = sample.chances[f];
      chance *= (wanted & maskOf(f)) != 0 ? p : 1 - p;
    }
    no += chance;
  }
  return no;
}

RC_GTEST_PROP(OutcomeEntropy, ChanceOfNoIsNeverTooHigh, ()) {
  const Sample sample = anySample();
  const double chance = chanceOfNo(sample.dnf, sample.chances);
  RC_ASSERT(chance >= 0);
  RC_ASSERT(chance <= exactChanceOfNo(sample) + 1e-9);
  if (isDisjoint(sample.dnf)) RC_ASSERT(chance >= exactChanceOfNo(sample) - 1e-9);
}

TEST(OutcomeEntropy, SeesWhatIsSharedHoweverUnlikely) {
  MonotoneDnf star;
  for (std::size_t arm = 1; arm < 10; ++arm)
    star.add(maskOf(0) | maskOf(arm));
  for (const double p : {1e-100, 1e-10, 0.1})
    EXPECT_EQ(mostInformative(star, Chances(std::vector<double>(10, p))), maskOf(0)) << p;
}

TEST(OutcomeEntropy, WithoutUncertaintyNothingIsInformative) {
  MonotoneDnf dnf;
  dnf.add(0b011);
  dnf.add(0b110);
  EXPECT_EQ(mostInformative(dnf, Chances({0, 0, 0})), 0U);
  EXPECT_EQ(mostInformative(dnf, Chances({1, 1, 1})), 0U);
  EXPECT_NE(mostInformative(dnf, Chances({0, 0.5, 1})), 0U);
}

}  // namespace
}  // namespace goal_alignment::questions
