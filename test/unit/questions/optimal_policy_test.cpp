// SPDX-License-Identifier: BSD-3-Clause
#include "questions/optimal_policy.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "oracles/dialogues.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

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
  Situation situation = samples::anyFamily(random, 6);
  oracles::BestDialogue best(situation);
  const auto policy = policyOf("optimal", random.below(10));
  requireBestEverywhere(*policy, best, situation, 0);
}

RC_GTEST_PROP(OptimalPolicy, AsksAsFewAsTheBestDialogue, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anyFamily(random, 8, 12);
  const double least = oracles::BestDialogue(situation).cost(situation.knowledge);
  const double found = oracles::expectedQuestions(*policyOf("optimal"), situation);
  RC_LOG() << found << " instead of " << least;
  RC_ASSERT(std::abs(found - least) < 1e-9 * std::max(1.0, least));
}

RC_GTEST_PROP(OptimalPolicy, TreatsSuspectedConflictsLikeOthers, ()) {
  RandomSource random = oracles::anySource();
  Situation situation = samples::anyFamily(random, 6);
  const double proven = oracles::expectedQuestions(*policyOf("optimal"), situation);
  for (achievability::Conflict& each : situation.conflicts)
    each.proven = !each.proven;
  const double suspected = oracles::expectedQuestions(*policyOf("optimal"), situation);
  RC_ASSERT(std::abs(proven - suspected) < 1e-9 * std::max(1.0, proven));
}

}  // namespace
}  // namespace goal_alignment::questions
