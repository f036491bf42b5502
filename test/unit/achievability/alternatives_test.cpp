// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "goal_alignment/achievability/achievability.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"

namespace goal_alignment::achievability {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::make;
using samples::setOf;

/// The minimal sets to give up, by trying all.
std::set<CandidateBits> minimalToGiveUp(const Hagl& hagl, CandidateBits wanted) {
  std::set<CandidateBits> result;
  for (CandidateBits set = 0; set <= hagl.all(); ++set) {
    if ((set & ~wanted) != 0 || !hagl.achievable(wanted & ~set)) continue;
    bool minimal = true;
    for (std::size_t f = 0; f < hagl.size(); ++f) {
      const CandidateBits less = set & ~(CandidateBits{1} << f);
      minimal = minimal && (less == set || !hagl.achievable(wanted & ~less));
    }
    if (minimal) result.insert(set);
  }
  return result;
}

double probability(CandidateBits given_up, const std::vector<double>& belief) {
  double product = 1;
  for (std::size_t f = 0; f < belief.size(); ++f) {
    if (((given_up >> f) & 1U) != 0) product *= 1 - belief[f];
  }
  return product;
}

std::vector<double> drawBelief(RandomSource& random, std::size_t candidates) {
  const bool tied = oracles::chance(random, 0.3);
  std::vector<double> belief;
  belief.reserve(candidates);
  for (std::size_t f = 0; f < candidates; ++f)
    belief.push_back(tied ? 0.5 : static_cast<double>(random.below(101)) / 100);
  return belief;
}

std::vector<CandidateBits> bits(const std::vector<CandidateSet>& sets) {
  std::vector<CandidateBits> result;
  result.reserve(sets.size());
  for (const CandidateSet& set : sets)
    result.push_back(set.to_ulong());
  return result;
}

bool isOrdered(const std::vector<CandidateBits>& sets, const std::vector<double>& belief) {
  for (std::size_t i = 1; i < sets.size(); ++i) {
    if (probability(sets[i], belief) > probability(sets[i - 1], belief) + 1e-9) return false;
  }
  return true;
}

RC_GTEST_PROP(Alternatives, EqualBruteForceInTheOrderOfBelief, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  for (SearchBudget budget : samples::stageBudgets()) {
    if (budget.second_greedy == 1) budget.first_greedy = 1'000'000;
    const auto robot = make(hagl, budget);
    if (oracles::chance(random, 0.3)) robot->findAllConflicts({});
    for (int i = 0; i < 4; ++i) {
      const CandidateBits wanted = i == 0 ? hagl.all() : random.below(hagl.all() + 1);
      const std::vector<double> belief = drawBelief(random, hagl.size());
      const std::set<CandidateBits> expected = minimalToGiveUp(hagl, wanted);
      const std::size_t max_sets = oracles::chance(random, 0.5) ? 1000 : 1 + random.below(3);
      const auto found =
          bits(robot->alternatives(setOf(hagl.size(), wanted), belief, max_sets, {}));
      RC_ASSERT(found.size() == std::min(max_sets, expected.size()));
      RC_ASSERT(isOrdered(found, belief));
      for (const CandidateBits set : found)
        RC_ASSERT(expected.count(set) == 1U);
      RC_ASSERT(std::set<CandidateBits>(found.begin(), found.end()).size() == found.size());
      // What was left out is no likelier than what was not.
      for (const CandidateBits set : expected) {
        const bool listed = std::count(found.begin(), found.end(), set) > 0;
        if (listed || found.empty()) continue;
        RC_ASSERT(probability(set, belief) <= probability(found.back(), belief) + 1e-9);
      }
    }
  }
}

RC_GTEST_PROP(Alternatives, CanBeHadHoweverSmallTheBudgets, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const SearchBudget budget = {random.below(6), random.below(6), random.below(6),
                               random.below(6), random.below(6), 1,
                               random.below(6)};
  const auto robot = make(hagl, budget);
  const CandidateBits wanted = random.below(hagl.all() + 1);
  const std::vector<double> belief = drawBelief(random, hagl.size());
  const auto found = bits(robot->alternatives(setOf(hagl.size(), wanted), belief, 1000, {}));
  RC_ASSERT(isOrdered(found, belief));
  for (const CandidateBits a : found) {
    RC_ASSERT((a & ~wanted) == 0U);
    RC_ASSERT(hagl.achievable(wanted & ~a));
    for (const CandidateBits b : found)
      RC_ASSERT(a == b || (a & ~b) != 0U);
  }
}

TEST(Alternatives, EndWhenCancelled) {
  RandomSource random(5);
  const Hagl hagl = oracles::randomDisputedHagl(random);
  const auto robot = make(hagl);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  const std::vector<double> belief(hagl.size(), 0.5);
  const CandidateSet all = setOf(hagl.size(), hagl.all());
  EXPECT_TRUE(robot->alternatives(all, belief, 10, limits).empty());
  EXPECT_FALSE(robot->alternatives(all, belief, 10, {}).empty());
}

}  // namespace
}  // namespace goal_alignment::achievability
