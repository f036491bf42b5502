// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/goal_set_task.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/task/state.h"
#include "oracles/lifted_space.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "parts.h"

namespace goal_alignment::achievability {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;

GoalSetTask taskOf(const Hagl& hagl, const Limits& limits = {}) {
  return {samples::grounded(hagl), hagl.specified, hagl.candidates, limits};
}

RC_GTEST_PROP(GoalSetTask, KnowsWhatIsAlwaysAndNeverTrue, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const GoalSetTask task = taskOf(hagl);
  RC_ASSERT(task.candidateCount() == hagl.size());
  const std::vector<oracles::Atoms> states = oracles::LiftedSpace(hagl.robot, 10'000).states();
  for (std::size_t f = 0; f < hagl.size(); ++f) {
    const auto holds = [&](const oracles::Atoms& atoms) {
      return oracles::holds({hagl.candidates[f]}, atoms);
    };
    if (task.alwaysTrue().test(f)) RC_ASSERT(std::all_of(states.begin(), states.end(), holds));
    if (task.neverTrue().test(f)) RC_ASSERT(std::none_of(states.begin(), states.end(), holds));
    if (!task.factOf(f)) RC_ASSERT(task.alwaysTrue().test(f) || task.neverTrue().test(f));
  }
}

RC_GTEST_PROP(GoalSetTask, ItsConflictsAreSoundAndSmall, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const GoalSetTask task = taskOf(hagl);
  for (const Conflict& conflict : task.conflicts().all()) {
    RC_ASSERT(conflict.proven);
    RC_ASSERT(conflict.members.count() <= 2U);
    RC_ASSERT(!hagl.achievable(conflict.members.to_ulong()));
  }
}

RC_GTEST_PROP(GoalSetTask, AStateSatisfiesAGoalWithWhatItHolds, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  const GoalSetTask task = taskOf(hagl);
  const task::State state = task::initialState(task.task());
  const CandidateSet now = task.satisfiedBy(state.data());
  RC_ASSERT(task.alwaysTrue().is_subset_of(now));
  for (std::size_t f = 0; f < hagl.size(); ++f)
    RC_ASSERT(!task.neverTrue().test(f) || !now.test(f));
  const bool specified = task::satisfies(state.data(), task.specified());
  for (CandidateBits bits = 0; bits <= hagl.all(); ++bits) {
    const CandidateSet set(hagl.size(), bits);
    if ((set & task.neverTrue()).any())
      continue;  // such a candidate has no fact, so no goal says it
    RC_ASSERT(task::satisfies(state.data(), task.goalWith(set)) ==
              (specified && set.is_subset_of(now)));
    RC_ASSERT(task.factsOf(set).size() <= set.count());
  }
}

TEST(GoalSetTask, StopsWhenCancelled) {
  RandomSource random(3);
  const Hagl hagl = oracles::randomHagl(random);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(taskOf(hagl, limits), LimitReached);
}

}  // namespace
}  // namespace goal_alignment::achievability
