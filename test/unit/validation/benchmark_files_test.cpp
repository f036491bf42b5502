// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/validation/execution.h"

namespace goal_alignment::validation {
namespace {

namespace fs = std::filesystem;

/// The benchmarks live outside the repository: `$GOAL_ALIGNMENT_SHARED/benchmarks`, or the folder
/// `shared` beside this source tree.
fs::path benchmarks() {
  if (const char* shared = std::getenv("GOAL_ALIGNMENT_SHARED")) {
    return fs::path(shared) / "benchmarks";
  }
  const fs::path source_dir = fs::path(__FILE__).parent_path() / "../../..";
  return (source_dir / "../shared/benchmarks").lexically_normal();
}

std::vector<fs::path> filesNamed(const std::string& name) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(benchmarks())) {
    if (entry.path().filename() == name) found.push_back(entry.path());
  }
  return found;
}

pddl::Source read(const fs::path& path) {
  return pddl::readFile(path.string());
}

class BenchmarkFiles : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(benchmarks())) {
      GTEST_SKIP() << "no benchmarks at " << benchmarks() << "; set GOAL_ALIGNMENT_SHARED";
    }
  }
};

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
  const std::vector<fs::path> plans = filesNamed("human_plan.txt");
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
  for (const fs::path& path : filesNamed("human_plan.txt")) {
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
