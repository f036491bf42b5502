// SPDX-License-Identifier: BSD-3-Clause
#include "questions/optimal_policy.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "generators/conflict_families.h"
#include "oracles/dialogues.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using benchmarks::expectedQuestions;
using samples::conflict;
using samples::fresh;
using samples::policyOf;

/// Every situation that answers lead to, in any order of asking; the policy must be able to answer
/// the person who volunteers.
void requireBestEverywhere(Policy& policy, oracles::BestDialogue& best, Situation& situation,
                           std::size_t candidate) {
  if (candidate < situation.knowledge.size()) {
    for (const Knowledge each : {Knowledge::Open, Knowledge::Wanted, Knowledge::NotWanted}) {
      situation.knowledge[candidate] = each;
      requireBestEverywhere(policy, best, situation, candidate + 1);
    }
    return;
  }
  const auto choice = policy.next(situation);
  RC_ASSERT(choice.has_value() == !oracles::hasEnded(situation));
  if (!choice) return;
  const double least = best.cost(situation.knowledge);
  const double of_choice = best.costOf(situation.knowledge, choice->candidate);
  RC_LOG() << "asking " << choice->candidate << " costs " << of_choice << ", not " << least;
  RC_ASSERT(std::abs(of_choice - least) < 1e-8);
}

RC_GTEST_PROP(OptimalPolicy, AsksWhatIsBestInEverySituation, ()) {
  RandomSource random = oracles::anySource();
  Situation situation = samples::anyUnanswered(random, 6);
  oracles::BestDialogue best(situation);
  const auto policy = policyOf("optimal", random.below(10));
  requireBestEverywhere(*policy, best, situation, 0);
}

RC_GTEST_PROP(OptimalPolicy, AsksAsFewAsTheBestDialogue, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anyUnanswered(random, 8, 12);
  const double least = oracles::BestDialogue(situation).cost(situation.knowledge);
  const double found = expectedQuestions(*policyOf("optimal"), situation);
  RC_LOG() << found << " instead of " << least;
  RC_ASSERT(std::abs(found - least) < 1e-9 * std::max(1.0, least));
}

RC_GTEST_PROP(OptimalPolicy, TreatsSuspectedConflictsLikeOthers, ()) {
  RandomSource random = oracles::anySource();
  Situation situation = samples::anyUnanswered(random, 6);
  const double proven = expectedQuestions(*policyOf("optimal"), situation);
  for (achievability::Conflict& each : situation.conflicts)
    each.proven = !each.proven;
  const double suspected = expectedQuestions(*policyOf("optimal"), situation);
  RC_ASSERT(std::abs(proven - suspected) < 1e-9 * std::max(1.0, proven));
}

RC_GTEST_PROP(OptimalPolicy, AsksAsFewAsTheBestDialogueAmongEquallyLikely, ()) {
  RandomSource random = oracles::anySource();
  Situation situation = samples::anyUnanswered(random, 8, 12);
  for (double& p : situation.probability)
    p = 0.2 + 0.3 * static_cast<double>(random.below(2));
  const double least = oracles::BestDialogue(situation).cost(situation.knowledge);
  RC_ASSERT(std::abs(expectedQuestions(*policyOf("optimal"), situation) - least) < 1e-9);
}

// With hardly any work allowed it still asks, if not the best.
RC_GTEST_PROP(OptimalPolicy, WithoutWorkItGuessesWell, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anyUnanswered(random, 8, 12);
  OptimalPolicy policy(PolicyContext{}, random.below(500));
  const double least = oracles::BestDialogue(situation).cost(situation.knowledge);
  const double found = expectedQuestions(policy, situation);
  RC_ASSERT(found >= least - 1e-9);
  RC_ASSERT(found <= 2 * least);
}

// What decides is one choice out of many: a star's centre is asked at once, whatever its arms are.
TEST(OptimalPolicy, AStarOfSixtyArmsIsNoWork) {
  Situation situation = fresh(61, {});
  for (std::size_t arm = 1; arm <= 60; ++arm)
    situation.conflicts.push_back(conflict(61, 1 | std::uint64_t{1} << arm));
  OptimalPolicy policy(PolicyContext{}, 10'000);
  EXPECT_EQ(policy.next(situation)->candidate, 0U);
}

TEST(OptimalPolicy, ManyLoneConflictsAreNoWork) {
  RandomSource random(1);
  Situation situation = benchmarks::conflictFamily("disjoint", 60, 0, 0.1, 0.9, random);
  OptimalPolicy policy(PolicyContext{}, 0);
  EXPECT_NEAR(situation.probability[policy.next(situation)->candidate],
              situation.probability[policyOf("ratio")->next(situation)->candidate], 1e-9);
}

TEST(OptimalPolicy, RatherGuessesThanLeaveOutWhatDoesNotFit) {
  RandomSource random(1);
  const Situation situation = benchmarks::conflictFamily("chain", 100, 0, 0.1, 0.9, random);
  EXPECT_TRUE(policyOf("optimal")->next(situation).has_value());
}

// The second decision looks at what the first one has left.
TEST(OptimalPolicy, RemembersFromOneDecisionToTheNext) {
  RandomSource random(1);
  Situation situation = benchmarks::conflictFamily("triples", 12, 14, 0.05, 0.3, random);
  std::uint64_t polls = 0;
  PolicyContext context;
  context.poll = [&] { ++polls; };
  OptimalPolicy policy(context);
  const auto first = policy.next(situation);
  EXPECT_GT(polls, 1U);
  polls = 0;
  situation.knowledge[first->candidate] = Knowledge::NotWanted;
  policy.next(situation);
  EXPECT_LE(polls, 1U);
}

TEST(OptimalPolicy, EndsWhenItsPollThrows) {
  RandomSource random(1);
  const Situation situation = benchmarks::conflictFamily("triples", 30, 200, 0.05, 0.3, random);
  PolicyContext context;
  int polls = 0;
  context.poll = [&] {
    if (++polls == 10) throw std::runtime_error("cancelled");
  };
  EXPECT_THROW(OptimalPolicy(context).next(situation), std::runtime_error);
}

}  // namespace
}  // namespace goal_alignment::questions
