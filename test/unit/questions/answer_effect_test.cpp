// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/answer_effect.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <vector>

#include "goal_alignment/questions/policy.h"
#include "oracles/seeds.h"
#include "samples.h"

namespace goal_alignment::questions {
namespace {

using achievability::CandidateSet;
using achievability::Conflict;
using Ending = AnswerEffect::Ending;

Conflict conflictOf(std::size_t size, const std::vector<std::size_t>& members, bool proven = true) {
  Conflict conflict;
  conflict.members.resize(size);
  for (const std::size_t f : members)
    conflict.members.set(f);
  conflict.proven = proven;
  return conflict;
}

/// Two conflicts, {0, 1} and {1, 2, 3}; 4 is in none.
Situation two() {
  Situation situation;
  situation.knowledge.assign(5, Knowledge::Open);
  situation.probability.assign(5, 0.5);
  situation.conflicts = {conflictOf(5, {0, 1}), conflictOf(5, {1, 2, 3})};
  return situation;
}

TEST(AnswerEffect, ANoMaySettleEverything) {
  const AnswerEffect found = answerEffect(two(), {1}, Knowledge::NotWanted);
  EXPECT_EQ(found.ending, Ending::Plan);
  EXPECT_EQ(found.settled, 3U);  // 0, 2 and 3
  EXPECT_EQ(found.left, 0U);
}

TEST(AnswerEffect, ANoMaySettleAPart) {
  const AnswerEffect found = answerEffect(two(), {0}, Knowledge::NotWanted);
  EXPECT_EQ(found.ending, Ending::Open);
  EXPECT_EQ(found.settled, 0U);  // 1 is still in the other conflict
  EXPECT_EQ(found.left, 3U);
  EXPECT_EQ(answerEffect(two(), {2}, Knowledge::NotWanted).settled, 1U);
}

TEST(AnswerEffect, AYesMayProveThatThereIsNoPlan) {
  Situation situation = two();
  situation.knowledge[0] = Knowledge::Wanted;
  EXPECT_EQ(answerEffect(situation, {1}, Knowledge::Wanted).ending, Ending::NoPlan);
  EXPECT_EQ(answerEffect(situation, {2}, Knowledge::Wanted).ending, Ending::Open);
  EXPECT_EQ(answerEffect(two(), {0, 1}, Knowledge::Wanted).ending, Ending::NoPlan);
}

TEST(AnswerEffect, NothingIsProvenByWhatIsUnsureOrSuspected) {
  Situation situation = two();
  situation.knowledge[0] = Knowledge::Unsure;
  EXPECT_EQ(answerEffect(situation, {1}, Knowledge::Wanted).ending, Ending::Undecided);
  situation = two();
  situation.conflicts[0].proven = false;
  EXPECT_EQ(answerEffect(situation, {0, 1}, Knowledge::Wanted).ending, Ending::Undecided);
}

TEST(AnswerEffect, WhatMattersIsOpenAndInALiveConflict) {
  Situation situation = two();
  EXPECT_EQ(achievability::members(situation.relevantCandidates()),
            (std::vector<std::size_t>{0, 1, 2, 3}));
  situation.knowledge[2] = Knowledge::Unsure;
  situation.knowledge[0] = Knowledge::NotWanted;
  EXPECT_EQ(achievability::members(situation.relevantCandidates()),
            (std::vector<std::size_t>{1, 3}));
  situation.knowledge[1] = Knowledge::NotWanted;
  EXPECT_TRUE(situation.relevantCandidates().none());
}

TEST(AnswerEffect, WithoutConflictsThereIsAPlan) {
  Situation situation = two();
  situation.conflicts.clear();
  EXPECT_EQ(answerEffect(situation, {}, Knowledge::Wanted).ending, Ending::Plan);
}

RC_GTEST_PROP(AnswerEffect, CountsWhatIsStillOpenInALiveConflict, ()) {
  RandomSource random = oracles::anySource();
  Situation situation;
  const std::size_t size = 1 + random.below(7);
  for (std::size_t f = 0; f < size; ++f)
    situation.knowledge.push_back(static_cast<Knowledge>(random.below(4)));
  situation.probability.assign(size, 0.5);
  for (std::size_t i = random.below(6); i > 0; --i) {
    std::vector<std::size_t> members = {random.below(size)};
    while (oracles::chance(random, 0.6))
      members.push_back(random.below(size));
    situation.conflicts.push_back(conflictOf(size, members, oracles::chance(random, 0.7)));
  }
  const auto relevantCandidates = [](const Situation& now) {
    std::set<std::size_t> result;
    for (const Conflict& conflict : now.conflicts) {
      if (!now.isLive(conflict)) continue;
      for (const std::size_t f : achievability::members(conflict.members))
        if (now.knowledge[f] == Knowledge::Open) result.insert(f);
    }
    return result;
  };
  const std::size_t asked = random.below(size);
  RC_PRE(situation.knowledge[asked] == Knowledge::Open);
  for (const Knowledge answer : {Knowledge::Wanted, Knowledge::NotWanted, Knowledge::Unsure}) {
    Situation then = situation;
    then.knowledge[asked] = answer;
    std::set<std::size_t> before = relevantCandidates(situation);
    before.erase(asked);
    const AnswerEffect found = answerEffect(situation, {asked}, answer);
    RC_ASSERT(found.settled + found.left == before.size());
    if (found.ending == Ending::Open) {
      RC_ASSERT(found.left == relevantCandidates(then).size());
      RC_ASSERT(found.left > 0U);
    } else {
      RC_ASSERT(found.left == 0U);
    }
  }
}

}  // namespace
}  // namespace goal_alignment::questions
