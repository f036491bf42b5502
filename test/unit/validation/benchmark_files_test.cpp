// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/validation/execution.h"
#include "unit/benchmarks.h"

namespace goal_alignment::validation {
namespace {

namespace fs = std::filesystem;

using goal_alignment::samples::benchmarks;

std::vector<fs::path> filesNamed(const std::string& name) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(benchmarks())) {
    if (entry.path().filename() == name) found.push_back(entry.path());
  }
  return found;
}

// Those of instances that say what the person truly wants.
std::vector<fs::path> humanPlans() {
  std::vector<fs::path> found;
  for (const fs::path& path : filesNamed("human_plan.txt")) {
    if (fs::exists(path.parent_path() / "true_goal.txt")) found.push_back(path);
  }
  return found;
}

pddl::Source read(const fs::path& path) {
  return pddl::readFile(path.string());
}

class BenchmarkFiles : public goal_alignment::samples::BenchmarkTest {};

TEST_F(BenchmarkFiles, EveryTaskLinks) {
  std::size_t tasks = 0;
  for (const std::string prefix : {"", "human_", "robot_"}) {
    for (const fs::path& domain : filesNamed(prefix + "domain.pddl")) {
      const fs::path problem = domain.parent_path() / (prefix + "problem.pddl");
      const std::vector<std::string> faults = pddl::faults(read(domain), read(problem));
      EXPECT_TRUE(faults.empty()) << faults.front();
      ++tasks;
    }
  }
  EXPECT_GT(tasks, 0U);
}

TEST_F(BenchmarkFiles, EveryHumanPlanReachesItsGoals) {
  const std::vector<fs::path> plans = humanPlans();
  EXPECT_FALSE(plans.empty());
  for (const fs::path& path : plans) {
    const fs::path folder = path.parent_path();
    const pddl::Model human =
        pddl::readModel(read(folder / "human_domain.pddl"), read(folder / "human_problem.pddl"));
    const std::vector<GroundName> steps = pddl::parsePlan(read(path)).steps;
    EXPECT_FALSE(steps.empty());
    EXPECT_EQ(fault(human, steps, human.goalLiterals()), std::nullopt) << folder;
    const std::vector<Literal> true_goal = pddl::parseLiterals(read(folder / "true_goal.txt"));
    EXPECT_FALSE(true_goal.empty());
    EXPECT_EQ(fault(human, steps, true_goal), std::nullopt) << folder;
  }
}

// The plan was found optimal for the true goal, so a validator that accepts its cut prefixes would
// accept anything.
TEST_F(BenchmarkFiles, NoHumanPlanReachesTheTrueGoalWithoutItsLastStep) {
  for (const fs::path& path : humanPlans()) {
    const fs::path folder = path.parent_path();
    const pddl::Model human =
        pddl::readModel(read(folder / "human_domain.pddl"), read(folder / "human_problem.pddl"));
    std::vector<GroundName> steps = pddl::parsePlan(read(path)).steps;
    steps.pop_back();
    EXPECT_TRUE(fault(human, steps, pddl::parseLiterals(read(folder / "true_goal.txt")))) << folder;
  }
}

}  // namespace
}  // namespace goal_alignment::validation
