// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/achievability/achieved_sets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <vector>

#include "oracles/seeds.h"

namespace goal_alignment::achievability {
namespace {

RC_GTEST_PROP(AchievedSets, CoversExactlyTheSubsetsOfWhatWasAdded, ()) {
  RandomSource random = oracles::anySource();
  AchievedSets achieved;
  std::vector<CandidateSet> added;
  for (int i = 0; i < 12; ++i) {
    const CandidateSet set(6, random.below(64));
    achieved.add(set, {static_cast<task::OperatorId>(i)});
    added.push_back(set);
  }
  for (std::uint64_t bits = 0; bits < 64; ++bits) {
    const CandidateSet set(6, bits);
    bool expected = false;
    for (const CandidateSet& known : added)
      expected = expected || set.is_subset_of(known);
    const AchievedSets::Achieved* covering = achieved.covering(set);
    RC_ASSERT((covering != nullptr) == expected);
    if (covering == nullptr) continue;
    RC_ASSERT(set.is_subset_of(covering->set));
    RC_ASSERT(added[covering->plan.front()] == covering->set);  // the plan belongs to the set
  }
  for (const auto& a : achieved.all()) {
    for (const auto& b : achieved.all())
      RC_ASSERT(&a == &b || !a.set.is_subset_of(b.set));
  }
}

RC_GTEST_PROP(AchievedSets, AddingManyMaximalOnesIsAddingEach, ()) {
  RandomSource random = oracles::anySource();
  AchievedSets one_by_one;
  AchievedSets together;
  AchievedSets maximal;
  for (int i = 0; i < 6; ++i) {
    const CandidateSet old(6, random.below(64));
    one_by_one.add(old, {});
    together.add(old, {});
    maximal.add(CandidateSet(6, random.below(64)), {});
  }
  for (const auto& achieved : maximal.all())
    one_by_one.add(achieved.set, achieved.plan);
  together.addMaximal(maximal.all());
  const auto sets = [](const AchievedSets& achieved) {
    std::set<CandidateSet> result;
    for (const auto& entry : achieved.all())
      result.insert(entry.set);
    return result;
  };
  RC_ASSERT(sets(together) == sets(one_by_one));
  RC_ASSERT(together.all().size() == one_by_one.all().size());
}

}  // namespace
}  // namespace goal_alignment::achievability
