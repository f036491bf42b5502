// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/solve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "goal_alignment/common/exceptions.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"
#include "samples.h"

namespace goal_alignment::search {
namespace {

using task::FactId;
using task::Task;

RC_GTEST_PROP(Solve, FindsAPlanOrProvesThatThereIsNone, ()) {
  RandomSource random = oracles::anySource();
  const Task task = oracles::randomTask(random);
  const task::Goal goal = oracles::randomAlternatives(random, task);
  const auto best = oracles::optimalCost(task, oracles::initialFacts(task), goal);
  for (const Seek seek : {Seek::AnyPlan, Seek::OptimalPlan}) {
    const Result result = solve(task, goal, seek, {});
    RC_ASSERT(result.status == (best ? Status::Solved : Status::Unsolvable));
    if (!best) continue;
    RC_ASSERT(samples::valid(task, goal, result));
    if (seek == Seek::OptimalPlan) RC_ASSERT(result.cost == *best);
  }
}

TEST(Solve, AGoalWithoutAlternativesIsUnsolvable) {
  EXPECT_EQ(solve(samples::switches(2), task::Goal(), Seek::AnyPlan, {}).status,
            Status::Unsolvable);
}

/// As many pigeons as holes and one more; they come and go.
Task pigeons(FactId holes) {
  const FactId count = holes + 1;
  Task task;
  const auto in = [&](FactId pigeon, FactId hole) { return pigeon * (holes + 2) + hole; };
  const auto out = [&](FactId pigeon) { return in(pigeon, holes); };
  const auto home = [&](FactId pigeon) { return in(pigeon, holes + 1); };
  const auto empty = [&](FactId hole) { return count * (holes + 2) + hole; };
  task.facts.resize(empty(holes));
  for (FactId p = 0; p < count; ++p) {
    task.initial.push_back(out(p));
    for (FactId h = 0; h < holes; ++h) {
      task.operators.push_back({{"enter", {std::to_string(p), std::to_string(h)}},
                                {out(p), empty(h)},
                                {in(p, h), home(p)},
                                {out(p), empty(h)}});
      task.operators.push_back({{"leave", {std::to_string(p), std::to_string(h)}},
                                {in(p, h)},
                                {out(p), empty(h)},
                                {in(p, h), home(p)}});
    }
  }
  for (FactId h = 0; h < holes; ++h)
    task.initial.push_back(empty(h));
  task.initial = task::makeFactSet(task.initial);
  for (task::Operator& op : task.operators) {
    op.precondition = task::makeFactSet(op.precondition);
    op.add = task::makeFactSet(op.add);
    op.del = task::makeFactSet(op.del);
  }
  return task;
}

// Millions of states, which no search would go through in so little memory.
TEST(Solve, ProvesByCounting) {
  const FactId holes = 8;
  const Task task = pigeons(holes);
  task::FactSet all_home;
  for (FactId p = 0; p <= holes; ++p)
    all_home.push_back(p * (holes + 2) + holes + 1);
  Limits limits;
  limits.bytes = std::size_t{200} << 20U;
  EXPECT_EQ(solve(task, all_home, Seek::AnyPlan, limits).status, Status::Unsolvable);
  all_home.pop_back();
  EXPECT_EQ(solve(task, all_home, Seek::AnyPlan, limits).status, Status::Solved);
}

TEST(Solve, HearsACancelAtOnce) {
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(solve(samples::switches(3), task::FactSet{1}, Seek::AnyPlan, limits), LimitReached);
}

}  // namespace
}  // namespace goal_alignment::search
