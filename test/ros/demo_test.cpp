// SPDX-License-Identifier: BSD-3-Clause
// The tea demo as demo.launch sets it up, told by demo_task.
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

Telling demoTask(const std::string& arguments) {
  Telling run;
  FILE* pipe = popen(("timeout 60 " NODE_FOLDER "/demo_task " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return run;
  char buffer[512];
  while (fgets(buffer, sizeof buffer, pipe) != nullptr)
    run.output += buffer;
  const int status = pclose(pipe);
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return run;
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

}  // namespace
}  // namespace goal_alignment::test
