// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/task_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "unit/source_root.h"

namespace goal_alignment::nodes {
namespace {

// The task.yaml of each demo against the files that `hagl` reads of the same folder.
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
      steps.push_back(ros_common::toAction(step));
    EXPECT_EQ(steps, pddl::parsePlan(pddl::readFile(folder + "/human_plan.txt")).steps);

    const auto true_goal = pddl::parseLiterals(pddl::readFile(folder + "/true_goal.txt"));
    const std::string problem = pddl::readFile(folder + "/human_problem.pddl").text;
    const std::string goal = problem.substr(problem.find("(:goal"));
    EXPECT_FALSE(task.goal.empty());
    for (const Fluent& fluent : task.goal) {
      EXPECT_EQ(std::count(true_goal.begin(), true_goal.end(), ros_common::toLiteral(fluent)), 1);
      EXPECT_NE(goal.find(ros_common::toLiteral(fluent).text()), std::string::npos);
    }
  }
}

TEST(TaskFile, holdsATask) {
  const HumanTask task = taskOfYaml(
      "task_id: t\nperson: Ann\ngoal: [(On a B), (not (p))]\nplan:\n  - (stack a b)\n", "t.yaml");
  EXPECT_EQ(task.task_id, "t");
  EXPECT_EQ(task.person, "Ann");
  ASSERT_EQ(task.goal.size(), 2U);
  EXPECT_EQ(task.goal[0].args, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(task.goal[1].negated);
  EXPECT_EQ(task.plan.at(0).name, "stack");
  EXPECT_TRUE(taskOfYaml("person: Ann", "t.yaml").plan.empty());
}

TEST(TaskFile, readsStepsAsPlansHaveThem) {
  const HumanTask task = taskOfYaml(
      "plan:\n  - stack a b\n  - \"stack(a, b)\"\n  - '0: STACK A B'\n  - \"0.0: (stack a b) "
      "[1]\"\n",
      "t.yaml");
  ASSERT_EQ(task.plan.size(), 4U);
  for (const PlanStep& step : task.plan) {
    EXPECT_EQ(step.name, "stack");
    EXPECT_EQ(step.args, (std::vector<std::string>{"a", "b"}));
  }
}

TEST(TaskFile, faultsNameTheFile) {
  const auto fault = [](const std::string& text) -> std::string {
    try {
      taskOfYaml(text, "t.yaml");
    } catch (const YamlError& error) {
      return error.what();
    }
    return "taken";
  };
  EXPECT_EQ(fault(""),
            "t.yaml:1:1: expected a map with task_id, person, goal and plan, found nothing");
  EXPECT_EQ(fault("- a"),
            "t.yaml:1:1: expected a map with task_id, person, goal and plan, found a list");
  EXPECT_EQ(fault("goal: (a)"), "t.yaml:1:7: expected a list, found '(a)'");
  EXPECT_EQ(fault("goal:\n  - (a)\n  - \"((\"").find("t.yaml:3:5: "), 0U);
  EXPECT_EQ(
      fault("plan:\n  - (a\n"),
      "t.yaml:2:5: '(a':1:3: expected an object or ')', found the end of the text; the '(a' at "
      "1:1 is still open");
  EXPECT_EQ(fault("plan: {a: b}"), "t.yaml:1:7: expected a list, found a map");
  EXPECT_EQ(fault("paln: [(a)]"), "t.yaml:1:1: expected task_id, person, goal, plan, found 'paln'");
  EXPECT_EQ(fault("person: [Ann]"), "t.yaml:1:9: expected person, found a list");
  EXPECT_EQ(fault("a: [").find("t.yaml:"), 0U);
  EXPECT_EQ(fault("\"").find("t.yaml:"), 0U);
}

}  // namespace
}  // namespace goal_alignment::nodes
