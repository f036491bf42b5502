// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/partial_search.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "generators/families.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/heuristics/mutex_groups.h"
#include "goal_alignment/search/symbolic.h"
#include "oracles/conditional_task.h"
#include "oracles/random_task.h"
#include "oracles/seeds.h"
#include "oracles/state_space.h"

namespace goal_alignment::achievability {
namespace {

using heuristics::MutexTable;
using search::SearchTask;
using search::Status;

/// As Achievability makes it.
struct Prepared {
  explicit Prepared(const task::Task& task)
      : mutexes(task, {}),
        ready(mutexes.withoutInapplicable(task), heuristics::mutexGroups(task, mutexes, {})) {}

  MutexTable mutexes;
  SearchTask ready;
};

RC_GTEST_PROP(PartialSearch, EqualsBruteForce, ()) {
  RandomSource random = oracles::anySource();
  const task::Task task = oracles::randomTask(random);
  const Prepared prepared(task);
  const std::set<oracles::Facts> states = oracles::conditionallyReachable(task);
  for (int i = 0; i < 5; ++i) {
    const task::Goal goal = oracles::randomAlternatives(random, task);
    const task::FactSet first =
        oracles::chance(random, 0.3) ? task::FactSet{} : oracles::randomGoal(random, task);
    const bool possible = std::any_of(states.begin(), states.end(), [&](const auto& state) {
      return oracles::holds(goal, state);
    });
    Limits limits;
    if (oracles::chance(random, 0.3)) limits = limits.withStates(random.below(200));
    const auto result = searchInParts(prepared.ready, prepared.mutexes, goal, first, limits);
    if (result.status == Status::Unsolvable) RC_ASSERT(!possible);
    if (result.status == Status::LimitReached) RC_ASSERT(result.limit == LimitReason::States);
    if (result.status != Status::Solved) {
      RC_ASSERT(!possible || result.status == Status::LimitReached);
      continue;
    }
    task::State state = task::initialState(prepared.ready.task());
    for (const task::OperatorId id : result.plan) {
      const task::Operator& op = prepared.ready.task().operators[id];
      const task::State before = state;
      RC_ASSERT(task::contains(before.data(), op.precondition));
      task::apply(op, before.data(), state.size(), state.data());
    }
    RC_ASSERT(task::satisfies(state.data(), goal));
  }
}

TEST(PartialSearch, StopsWhenCancelled) {
  RandomSource random(1);
  const task::Task task = oracles::randomTask(random);
  const Prepared prepared(task);
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  // A fact that is not true at first takes a step at least.
  for (task::FactId fact = 0; fact < task.facts.size(); ++fact) {
    if (task::has(task.initial, fact) || prepared.mutexes.mutex(fact, fact)) continue;
    const auto result =
        searchInParts(prepared.ready, prepared.mutexes, task::FactSet{fact}, {fact}, limits);
    EXPECT_EQ(result.status, Status::LimitReached);
    EXPECT_EQ(result.limit, LimitReason::Cancelled);
  }
}

// Four of eight dishes on three stands: the other dishes are too much for a diagram of the whole,
// and have nothing to do with it.
TEST(PartialSearch, ProvesByCountingAmongManyThings) {
  benchmarks::HouseholdSize size;
  size.rooms = 4;
  size.cupboards = 6;
  size.stands = 3;
  size.dishes = 8;
  RandomSource random(1);
  const benchmarks::Models models = benchmarks::household(size, random);
  const pddl::Model model = pddl::readModel({"domain.pddl", models.domain.text()},
                                            {"problem.pddl", models.problemText()});
  std::vector<Literal> wanted;
  for (const std::string dish : {"dish0", "dish1", "dish2", "dish3"})
    wanted.push_back(Literal::parse("(laid-out " + dish + ")"));
  const grounding::GroundTask ground = grounding::ground(model, wanted, {}, {});
  const Prepared prepared(ground.task);
  const task::Goal goal = ground.goal(wanted);
  Limits limits;
  limits.states = 100'000;
  const auto result =
      searchInParts(prepared.ready, prepared.mutexes, goal, goal.alternatives.front(), limits);
  EXPECT_EQ(result.status, Status::Unsolvable);
  search::Symbolic whole(prepared.ready.task(), prepared.ready.groups());
  EXPECT_EQ(whole.run(Limits{}.withStates(2'000'000)), LimitReason::States);
  // Three can be had, which a plan of the whole shows.
  wanted.pop_back();
  const task::Goal fewer = ground.goal(wanted);
  const auto plan =
      searchInParts(prepared.ready, prepared.mutexes, fewer, fewer.alternatives.front(), limits);
  EXPECT_EQ(plan.status, Status::Solved);
}

}  // namespace
}  // namespace goal_alignment::achievability
