// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/alignment/robot_analysis.h"
#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "samples.h"
#include "unit/benchmarks.h"

/// The instances that the published method was measured on: their conflicts were found by another
/// program, their outcomes by another planner.
namespace goal_alignment::session {
namespace {

namespace fs = std::filesystem;

using goal_alignment::samples::benchmarks;
using goal_alignment::samples::readBenchmark;

/// All but those that take seconds (elevators-2 and -3).
const std::vector<std::string> kInstances = {
    "blocks-1",    "blocks-2",    "blocks-3",    "blocks-4",    "blocks-5",    "driverlog-1",
    "driverlog-2", "driverlog-3", "driverlog-4", "driverlog-5", "elevators-1", "elevators-4",
    "elevators-5", "logistics-1", "logistics-2", "logistics-3", "logistics-4", "logistics-5",
    "rovers-1",    "rovers-2",    "rovers-3",    "rovers-4",    "rovers-5"};

Input readInstance(const fs::path& folder) {
  Input input;
  input.robot_domain = readBenchmark(folder / "robot_domain.pddl");
  input.robot_problem = readBenchmark(folder / "robot_problem.pddl");
  input.human_domain = readBenchmark(folder / "human_domain.pddl");
  input.human_problem = readBenchmark(folder / "human_problem.pddl");
  input.human_plan = pddl::parsePlan(readBenchmark(folder / "human_plan.txt")).steps;
  return input;
}

class HaglIpc : public goal_alignment::samples::BenchmarkTest,
                public testing::WithParamInterface<std::string> {
 protected:
  fs::path folder() const { return benchmarks() / "hagl-ipc" / GetParam(); }

  /// Aligns with a person of this true goal; the session at its end.
  Session align(const std::vector<Literal>& true_goal, Options chosen) const {
    Session session(std::move(chosen));
    session.begin(readInstance(folder()));
    samples::talk(session, [&](const Literal& fluent) {
      const bool wants = std::find(true_goal.begin(), true_goal.end(), fluent) != true_goal.end();
      return wants ? AnswerKind::Yes : AnswerKind::No;
    });
    return session;
  }
};

TEST_P(HaglIpc, ConflictsAreThoseOfTheOtherProgram) {
  Input input = readInstance(folder());
  const alignment::Problem problem = alignment::makeProblem(
      pddl::readModel(input.robot_domain, input.robot_problem),
      pddl::readModel(input.human_domain, input.human_problem), {}, std::move(input.human_plan));
  const alignment::RobotAnalysis robot = alignment::analyseRobot(problem, true, {}, {});
  EXPECT_TRUE(robot.achievability->findAllConflicts({}));
  std::set<std::set<Literal>> found;
  for (const auto& conflict : robot.achievability->conflicts()) {
    EXPECT_TRUE(conflict.proven && conflict.minimal);
    std::set<Literal> fluents;
    for (const std::size_t f : achievability::members(conflict.members)) {
      fluents.insert(problem.candidates[f].fluent);
    }
    found.insert(fluents);
  }
  const auto json = nlohmann::json::parse(readBenchmark(folder() / "conflicts.json").text);
  std::set<std::set<Literal>> expected;
  for (const auto& list : json["conflicts"]) {
    std::set<Literal> fluents;
    for (const std::string text : list)
      fluents.insert(Literal::parse(text));
    expected.insert(fluents);
  }
  EXPECT_EQ(found, expected);
}

TEST_P(HaglIpc, AutoFindsAPlanForTheTrueGoal) {
  const std::vector<Literal> true_goal =
      pddl::parseLiterals(readBenchmark(folder() / "true_goal.txt"));
  for (const ConflictMode mode : {ConflictMode::Full, ConflictMode::Lazy}) {
    const Session session = align(true_goal, samples::options("auto", mode));
    ASSERT_EQ(session.outcome().code, OutcomeCode::Success) << session.outcome().message;
    const pddl::Model robot = pddl::readModel(readBenchmark(folder() / "robot_domain.pddl"),
                                              readBenchmark(folder() / "robot_problem.pddl"));
    EXPECT_EQ(validation::fault(robot, session.outcome().plan.steps, true_goal), std::nullopt);
  }
}

TEST_P(HaglIpc, AutoProvesThatThereIsNoPlan) {
  const fs::path file = folder() / "true_goal_noplan.txt";
  if (!fs::exists(file)) GTEST_SKIP() << "there is no conflict that a true goal could contain";
  const std::vector<Literal> true_goal = pddl::parseLiterals(readBenchmark(file));
  const Session session = align(true_goal, samples::options("auto"));
  EXPECT_EQ(session.outcome().code, OutcomeCode::ExpectationUnachievable)
      << session.outcome().message;
  for (const Literal& fluent : session.outcome().conflict) {
    EXPECT_NE(std::find(true_goal.begin(), true_goal.end(), fluent), true_goal.end());
  }
}

INSTANTIATE_TEST_SUITE_P(Instances, HaglIpc, testing::ValuesIn(kInstances),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace goal_alignment::session
