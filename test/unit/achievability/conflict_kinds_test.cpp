// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generators/families.h"
#include "goal_alignment/achievability/achievability.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/pddl/model.h"
#include "samples.h"

/// Tasks made for the kinds of conflicts that pairs of facts don't show, and for those that lie in
/// what one model alone knows. Each is asked in all ways that a check can take.
namespace goal_alignment::achievability {
namespace {

using Names = std::set<std::string>;

struct PosedTask {
  pddl::Model robot;
  std::vector<Literal> specified;
  std::vector<Literal> candidates;
};

std::vector<Literal> literals(const std::vector<std::string>& texts) {
  std::vector<Literal> result;
  result.reserve(texts.size());
  for (const std::string& text : texts)
    result.push_back(Literal::parse(text));
  return result;
}

PosedTask posed(const std::string& domain, const std::string& problem,
                const std::vector<std::string>& specified,
                const std::vector<std::string>& candidates) {
  return {pddl::readModel({"domain.pddl", domain}, {"problem.pddl", problem}), literals(specified),
          literals(candidates)};
}

std::unique_ptr<Achievability> robotOf(const PosedTask& task, const SearchBudget& budget) {
  std::vector<Literal> goals = task.specified;
  goals.insert(goals.end(), task.candidates.begin(), task.candidates.end());
  return std::make_unique<Achievability>(grounding::ground(task.robot, goals, {}, {}),
                                         task.specified, task.candidates, budget, Limits{});
}

std::set<Names> conflictsOf(const PosedTask& task, const Achievability& robot) {
  std::set<Names> result;
  for (const Conflict& conflict : robot.conflicts()) {
    EXPECT_TRUE(conflict.proven && conflict.minimal);
    Names names;
    for (const std::size_t f : members(conflict.members))
      names.insert(task.candidates[f].text());
    result.insert(names);
  }
  return result;
}

/// Whichever way is taken, exactly these are found.
void expectConflicts(const PosedTask& task, const std::set<Names>& expected) {
  for (SearchBudget budget : samples::stageBudgets()) {
    if (budget.second_greedy == 1) budget.first_greedy = 1'000'000;
    const auto robot = robotOf(task, budget);
    EXPECT_TRUE(robot->findAllConflicts({}));
    EXPECT_EQ(conflictsOf(task, *robot), expected);
  }
}

std::vector<std::string> numbered(const std::string& before, std::size_t count,
                                  const std::string& after) {
  std::vector<std::string> result(count, before);
  for (std::size_t i = 0; i < count; ++i)
    result[i].append(std::to_string(i)).append(after);
  return result;
}

class Pigeonholes : public testing::TestWithParam<std::size_t> {};

// One ring more than there are pegs: all together are one conflict, of size 3, 4, 5.
TEST_P(Pigeonholes, AllRingsAreTheConflict) {
  RandomSource random(1);
  const benchmarks::Models models = benchmarks::pegs(static_cast<int>(GetParam()), random);
  const auto rings = numbered("(hangs ring", GetParam() + 1, ")");
  expectConflicts(posed(models.domain.text(), models.problemText(), {}, rings),
                  {Names(rings.begin(), rings.end())});
}

// With one ring asked for, its place is gone: the others are the conflict.
TEST_P(Pigeonholes, WhatWasAskedForTakesAPlace) {
  RandomSource random(1);
  const benchmarks::Models models = benchmarks::pegs(static_cast<int>(GetParam()), random);
  auto rings = numbered("(hangs ring", GetParam() + 1, ")");
  const std::string asked_for = rings.back();
  rings.pop_back();
  expectConflicts(posed(models.domain.text(), models.problemText(), {asked_for}, rings),
                  {Names(rings.begin(), rings.end())});
}

INSTANTIATE_TEST_SUITE_P(Sizes, Pigeonholes, testing::Values(2, 3, 4));

// A lift carries two: any three in one lift are a conflict, and one passenger in two lifts.
TEST(ConflictKinds, ALiftCountsItsPassengers) {
  RandomSource random(1);
  const benchmarks::Models models = benchmarks::lifts(4, random);
  std::vector<std::string> candidates = numbered("(rides passenger", 4, " lift0)");
  candidates.emplace_back("(rides passenger0 lift1)");
  std::set<Names> expected = {{candidates[0], candidates[4]}};
  for (std::size_t absent = 0; absent < 4; ++absent) {
    Names three(candidates.begin(), candidates.begin() + 4);
    three.erase(candidates[absent]);
    expected.insert(three);
  }
  expectConflicts(posed(models.domain.text(), models.problemText(), {}, candidates), expected);
}

const char* const kBlocks = R"((define (domain blocks)
  (:predicates (on ?x ?y) (ontable ?x) (clear ?x))
  (:action stack :parameters (?x ?y)
    :precondition (and (ontable ?x) (clear ?x) (clear ?y) (not (= ?x ?y)))
    :effect (and (on ?x ?y) (not (ontable ?x)) (not (clear ?y))))
  (:action unstack :parameters (?x ?y)
    :precondition (and (on ?x ?y) (clear ?x))
    :effect (and (ontable ?x) (clear ?y) (not (on ?x ?y))))))";

/// a, b, … on the table.
std::string blocksProblem(std::size_t blocks) {
  std::string objects;
  std::string init;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::string block(1, static_cast<char>('a' + i));
    objects.append(" ").append(block);
    init.append(" (ontable ").append(block).append(") (clear ").append(block).append(")");
  }
  return "(define (problem p) (:domain blocks) (:objects" + objects + ") (:init" + init +
         ") (:goal (and)))";
}

// A tower that bites its own tail, one block of it asked for: sizes 2, 3, 4 by the number of
// blocks.
TEST(ConflictKinds, ACycleCloses) {
  for (std::size_t blocks = 3; blocks <= 5; ++blocks) {
    std::vector<std::string> ring(blocks, "(on x y)");
    for (std::size_t i = 0; i < blocks; ++i) {
      ring[i][4] = static_cast<char>('a' + i);
      ring[i][6] = static_cast<char>('a' + (i + 1) % blocks);
    }
    const std::vector<std::string> others(ring.begin() + 1, ring.end());
    expectConflicts(posed(kBlocks, blocksProblem(blocks), {ring[0]}, others),
                    {Names(others.begin(), others.end())});
  }
}

const char* const kKitchen = R"((define (domain kitchen)
  (:predicates (made-of ?x ?m) (washed ?x) (broken ?x) (near ?x) (dry ?x))
  (:action wash :parameters (?x) :precondition (near ?x)
    :effect (and (washed ?x) (not (dry ?x))))))";
const char* const kKitchenProblem = R"((define (problem p) (:domain kitchen)
  (:objects cup pan glass china)
  (:init (made-of cup glass) (near cup) (dry cup) (dry pan)) (:goal (and))))";

// What no action changes: true is never asked about, false is a conflict by itself; and so is what
// the robot has no word for. None of it is part of another conflict.
TEST(ConflictKinds, StaticsAndForeignWords) {
  const PosedTask task =
      posed(kKitchen, kKitchenProblem, {"(washed cup)"},
            {"(made-of cup glass)", "(made-of cup china)", "(dry pan)", "(dry cup)", "(washed pan)",
             "(broken pan)", "(loved cup)", "(near teapot)", "(near cup)"});
  expectConflicts(task, {{"(made-of cup china)"},
                         {"(dry cup)"},
                         {"(washed pan)"},
                         {"(broken pan)"},
                         {"(loved cup)"},
                         {"(near teapot)"}});
  const auto robot = robotOf(task, {});
  EXPECT_TRUE(robot->alwaysTrue().test(0));
  EXPECT_FALSE(robot->alwaysTrue().test(1));
}

// What the person asked for is beyond the robot's words: nothing can be had, the empty set neither.
TEST(ConflictKinds, AForeignGoalIsTheEmptyConflict) {
  expectConflicts(posed(kKitchen, kKitchenProblem, {"(loved cup)"}, {"(washed cup)", "(dry pan)"}),
                  {Names{}});
}

TEST(ConflictKinds, WhereAllCanBeHadNothingIsLeftToFind) {
  const auto robot = robotOf(posed(kKitchen, kKitchenProblem, {"(washed cup)"},
                                   {"(dry pan)", "(made-of cup glass)", "(near cup)"}),
                             {});
  EXPECT_FALSE(robot->complete());
  const CandidateSet all = ~CandidateSet(3);
  robot->suspect(all);
  EXPECT_EQ(robot->check(all, {}).verdict, Verdict::Achievable);
  EXPECT_TRUE(robot->complete());
  EXPECT_TRUE(robot->conflicts().empty());
}

// Where the reachable states are too many to be gone through, what stays open is narrowed down and
// proven from a part of the task. Two of three stands are taken by what was asked for.
TEST(ConflictKinds, CountingAmongManyThingsIsProven) {
  benchmarks::HouseholdSize size;
  size.rooms = 2;
  size.cupboards = 2;
  size.stands = 2;
  size.dishes = 12;
  RandomSource random(3);
  const benchmarks::Models models = benchmarks::household(size, random);
  const PosedTask task = posed(models.domain.text(), models.problemText(), {"(laid-out dish0)"},
                               {"(laid-out dish1)", "(laid-out dish2)", "(shut cupboard0)",
                                "(robot-in room1)", "(idle hand0)"});
  SearchBudget budget;
  budget.first_symbolic = 1'000;
  budget.exhaustive = 1'000;
  budget.symbolic = 1'000;
  const auto proves = robotOf(task, budget);
  EXPECT_TRUE(proves->findAllConflicts({}));
  EXPECT_EQ(conflictsOf(task, *proves),
            (std::set<Names>{{"(laid-out dish1)", "(laid-out dish2)"}}));
  budget.parts = 1;
  const auto suspects = robotOf(task, budget);
  EXPECT_FALSE(suspects->findAllConflicts({}));
  ASSERT_EQ(suspects->conflicts().size(), 1U);
  EXPECT_FALSE(suspects->conflicts().front().proven);
  EXPECT_EQ(suspects->conflicts().front().members, proves->conflicts().front().members);
}

}  // namespace
}  // namespace goal_alignment::achievability
