// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/grouping.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "oracles/dialogues.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using samples::conflict;
using samples::fresh;
using samples::policyOf;

/// Calls with every combination of answers to the group, and how likely it is.
template <typename Function>
void forEachAnswer(const std::vector<Choice>& group, const Situation& situation,
                   const Function& function) {
  for (std::uint64_t yes = 0; yes < std::uint64_t{1} << group.size(); ++yes) {
    Situation answered = situation;
    double probability = 1;
    for (std::size_t i = 0; i < group.size(); ++i) {
      const std::size_t f = group[i].candidate;
      const bool wanted = (yes >> i & 1U) != 0;
      answered.knowledge[f] = wanted ? Knowledge::Wanted : Knowledge::NotWanted;
      probability *= wanted ? situation.probability[f] : 1 - situation.probability[f];
    }
    if (probability > 0) function(answered, probability);
  }
}

double undecidedAfter(const std::vector<Choice>& group, const Situation& situation) {
  double sum = 0;
  forEachAnswer(group, situation, [&](const Situation& answered, double probability) {
    if (!oracles::hasEnded(answered)) sum += probability;
  });
  return sum;
}

struct Effort {
  double rounds = 0;
  double shown = 0;
};

/// Exactly what a dialogue in groups is expected to take.
Effort expectedEffort(Policy& policy, const Situation& situation, std::size_t max_candidates) {
  Effort effort;
  if (oracles::hasEnded(situation)) return effort;
  const std::vector<Choice> group = nextGroup(policy, situation, max_candidates);
  RC_ASSERT(!group.empty());
  RC_ASSERT(group.size() <= max_candidates);
  effort = {1, static_cast<double>(group.size())};
  forEachAnswer(group, situation, [&](const Situation& answered, double probability) {
    const Effort later = expectedEffort(policy, answered, max_candidates);
    effort.rounds += probability * later.rounds;
    effort.shown += probability * later.shown;
  });
  return effort;
}

RC_GTEST_PROP(Grouping, OneAtATimeIsThePolicyAlone, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anySituation(random);
  for (const char* name : {"auto", "ratio", "optimal"}) {
    const std::uint64_t seed = random.below(10);
    const auto alone = policyOf(name, seed)->next(situation);
    const auto group = nextGroup(*policyOf(name, seed), situation, 1);
    RC_ASSERT(alone.has_value() == !group.empty());
    if (!alone) continue;
    RC_ASSERT(group.size() == 1U);
    RC_ASSERT(group.front().candidate == alone->candidate);
    RC_ASSERT(group.front().conflict == alone->conflict);
  }
}

RC_GTEST_PROP(Grouping, OffersOpenFluentsOnceEachWithItsReason, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anySituation(random);
  const std::size_t max_candidates = oracles::between(random, 1, 6);
  const char* const names[] = {"auto", "ratio", "optimal"};
  const auto group =
      nextGroup(*policyOf(names[random.below(3)], random.below(10)), situation, max_candidates);
  RC_ASSERT(group.size() <= max_candidates);
  RC_ASSERT(group.empty() == oracles::hasEnded(situation));
  std::set<std::size_t> offered;
  for (const Choice& choice : group) {
    RC_ASSERT(situation.knowledge[choice.candidate] == Knowledge::Open);
    const auto& reason = situation.conflicts.at(choice.conflict.value());
    RC_ASSERT(situation.isLive(reason));
    RC_ASSERT(reason.members.test(choice.candidate));
    RC_ASSERT(offered.insert(choice.candidate).second);
  }
}

// Up to six candidates there are no more leaves than are kept, so the estimate is exact.
RC_GTEST_PROP(Grouping, GoesOnWhileTheOutcomeIsLikelyOpen, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anyUnanswered(random, 9);
  const std::size_t max_candidates = oracles::between(random, 2, 6);
  auto group = nextGroup(*policyOf("auto", random.below(10)), situation, max_candidates);
  if (group.size() < max_candidates)
    RC_ASSERT(undecidedAfter(group, situation) < kMinUndecided + 1e-9);
  while (group.size() > 1) {
    group.pop_back();
    RC_ASSERT(undecidedAfter(group, situation) > kMinUndecided - 1e-9);
  }
}

RC_GTEST_PROP(Grouping, ExpectsNoMoreRoundsThanAskingOneByOne, ()) {
  RandomSource random = oracles::anySource();
  const Situation situation = samples::anyUnanswered(random, 7);
  const double least = oracles::BestDialogue(situation).cost(situation.knowledge);
  const auto policy = policyOf("optimal", random.below(10));
  double before = least;
  for (const std::size_t max_candidates : {1U, 2U, 6U}) {
    const Effort effort = expectedEffort(*policy, situation, max_candidates);
    RC_LOG() << max_candidates << ": " << effort.rounds << " rounds, " << effort.shown
             << " shown\n";
    RC_ASSERT(effort.rounds <= least + 1e-9);
    RC_ASSERT(effort.shown >= least - 1e-9);
    if (max_candidates == 1) RC_ASSERT(std::abs(effort.rounds - before) < 1e-9);
  }
}

TEST(Grouping, EndsInOneRoundWhereTheGroupHoldsAllThatMatters) {
  const Situation situation = fresh(5, {conflict(5, 0b00011), conflict(5, 0b01100)});
  const Effort effort = expectedEffort(*policyOf("auto"), situation, 5);
  EXPECT_LT(effort.rounds, 1.2);
  EXPECT_LE(effort.shown, 4.0);
}

TEST(Grouping, PoliciesWithoutConflictsOfferWhatComesNext) {
  PolicyContext context;
  context.is_static = {false, true, false, false};
  context.ask_static = false;
  const auto policy = makePolicy("ask-all", context);
  Situation situation = fresh(4, {conflict(4, 0b0101)});
  const auto two = nextGroup(*policy, situation, 2);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].candidate, 0U);
  EXPECT_EQ(two[0].conflict, 0U);
  EXPECT_EQ(two[1].candidate, 2U);
  EXPECT_EQ(two[1].conflict, 0U);
  EXPECT_EQ(nextGroup(*policy, situation, 9).size(), 3U);
  situation.knowledge[0] = Knowledge::NotWanted;
  EXPECT_EQ(nextGroup(*policy, situation, 1).front().conflict, std::nullopt);
  EXPECT_TRUE(nextGroup(*policy, situation, 0).empty());
}

}  // namespace
}  // namespace goal_alignment::questions
