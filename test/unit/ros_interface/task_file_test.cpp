// SPDX-License-Identifier: BSD-3-Clause
// The task.yaml of each demo against the files that `hagl` reads of the same folder.
#include "goal_alignment/ros_interface/task_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_interface/message_conversion.h"
#include "unit/source_root.h"

namespace goal_alignment::ros_interface {
namespace {

std::vector<std::string> taskFolders() {
  const auto root = sourceRoot() / "config/domains";
  std::vector<std::string> folders = {(root / "tea").string(), (root / "ward").string()};
  for (const auto& entry : std::filesystem::directory_iterator(root / "home"))
    if (entry.is_directory()) folders.push_back(entry.path().string());
  return folders;
}

TEST(TaskFiles, thereAreSixInTheHome) {
  EXPECT_EQ(taskFolders().size(), 8U);
}

TEST(TaskFiles, havePlanAndGoalOfTheirFolder) {
  for (const std::string& folder : taskFolders()) {
    SCOPED_TRACE(folder);
    const HumanTask task = taskOfFile(std::filesystem::canonical(folder + "/task.yaml").string());
    EXPECT_FALSE(task.person.empty());
    std::vector<GroundName> steps;
    for (const PlanStep& step : task.plan)
      steps.push_back(toAction(step));
    EXPECT_EQ(steps, pddl::parsePlan(pddl::readFile(folder + "/human_plan.txt")).steps);

    const auto true_goal = pddl::parseLiterals(pddl::readFile(folder + "/true_goal.txt"));
    const std::string problem = pddl::readFile(folder + "/human_problem.pddl").text;
    const std::string goal = problem.substr(problem.find("(:goal"));
    EXPECT_FALSE(task.goal.empty());
    for (const Fluent& fluent : task.goal) {
      EXPECT_EQ(std::count(true_goal.begin(), true_goal.end(), toLiteral(fluent)), 1);
      EXPECT_NE(goal.find(toLiteral(fluent).text()), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace goal_alignment::ros_interface
