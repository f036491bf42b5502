// SPDX-License-Identifier: BSD-3-Clause
// The tea demo as demo.launch sets it up, told by demo_task.
#include <ros/package.h>
#include <sys/wait.h>

#include <cstdio>
#include <string>

#include "scenario.h"

namespace goal_alignment::test {
namespace {

struct Telling {
  std::string output;
  int status = -1;
};

Telling told(const std::string& command) {
  Telling run;
  FILE* pipe = popen(("timeout 60 " + command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return run;
  char buffer[512];
  while (fgets(buffer, sizeof buffer, pipe) != nullptr)
    run.output += buffer;
  const int status = pclose(pipe);
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return run;
}

Telling demoTask(const std::string& arguments) {
  return told(NODE_FOLDER "/demo_task " + arguments);
}

TEST(Demo, tellsTheTaskTheBreakTheQuestionsTheStepsAndTheGuarantee) {
  const Telling run =
      demoTask("_task:=config/domains/tea/task.yaml _phrases:=config/domains/tea/phrases.yaml");
  EXPECT_EQ(run.status, 0) << run.output;
  std::size_t position = 0;
  for (const char* part : {"The task, from ", "Where this plan breaks for the robot: ",
                           "The robot asks: ", "  Its reason: ", " answers: ",
                           "The robot has a plan of ", "  step 1 of ", "\nGuaranteed: "}) {
    position = run.output.find(part, position);
    ASSERT_NE(position, std::string::npos) << part << " is missing in\n" << run.output;
  }
}

TEST(Demo, failsForATaskThatCannotBe) {
  EXPECT_EQ(demoTask("_task:=config/domains/tea/no_such_task.yaml").status, 1);
  // The problem's goal without a plan: it is not what the person expects.
  const Telling run = demoTask("_task:=test/ros/models/empty_task.yaml");
  EXPECT_EQ(run.status, 1) << run.output;
  EXPECT_NE(run.output.find("(outcome 72)"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("Guaranteed:"), std::string::npos) << run.output;
}

TEST(Demo, canBeDoneWithTheClientInPython) {
  const std::string client =
      ros::package::getPath("goal_alignment") + "/examples/align_and_execute.py";
  const Telling run = told(
      "/usr/bin/python3 " + client +
      " '(tea-served)' '(go counter back-door)' '(carry-ladder back-door cupboard)' '(climb-up)'"
      " '(take-from-high-shelf good-leaves)' '(take-from-high-shelf china-cup)' '(climb-down)'"
      " '(carry-ladder cupboard back-door)' '(go back-door counter)' '(wipe china-cup)'"
      " '(boil-kettle)' '(brew good-leaves filtered-water)' '(pour china-cup)' '(go counter table)'"
      " '(serve china-cup)'");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(told("/usr/bin/python3 " + client + " '(tea-served)'").status, 1)
      << "it is not planned";
}

}  // namespace
}  // namespace goal_alignment::test
