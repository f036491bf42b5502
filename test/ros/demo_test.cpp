// SPDX-License-Identifier: BSD-3-Clause
// The demos as demo.launch sets them up, told by demo_task.
#include <ros/package.h>
#include <ros/service.h>
#include <std_srvs/Trigger.h>
#include <sys/wait.h>

#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

#include "scenario.h"

namespace goal_alignment::test {
namespace {

struct Telling {
  std::string output;
  int status = -1;
};

Telling told(const std::string& command) {
  Telling run;
  FILE* pipe = popen(("timeout 300 " + command + " 2>&1").c_str(), "r");
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

// In this order, whatever else stands between.
void expectInOrder(const Telling& run, const std::vector<std::string>& parts) {
  EXPECT_EQ(run.status, 0) << run.output;
  std::size_t position = 0;
  for (const std::string& part : parts) {
    position = run.output.find(part, position);
    ASSERT_NE(position, std::string::npos) << part << " is missing in\n" << run.output;
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

class Demo : public testing::Test {
 protected:
  void SetUp() override { forgetWhatWasDone(); }

  // The world is as its files say, whatever was carried out before.
  static void forgetWhatWasDone() {
    ASSERT_TRUE(isOffered("/goal_alignment/forget_facts"));
    std_srvs::Trigger forget;
    ASSERT_TRUE(ros::service::call("/goal_alignment/forget_facts", forget));
    EXPECT_TRUE(forget.response.success) << forget.response.message;
  }
};

TEST_F(Demo, tellsTheTaskTheBreakTheQuestionsTheStepsAndTheGuarantee) {
  const Telling run =
      demoTask("_task:=config/domains/tea/task.yaml _phrases:=config/domains/tea/phrases.yaml");
  expectInOrder(run, {"The task, from ", "Where this plan breaks for the robot: ",
                      "The robot asks: ", "  Its reason: ", " answers: ",
                      "The robot has a plan of ", "  step 1 of ", "\nGuaranteed: "});
  EXPECT_EQ(count(run.output, "The robot asks: "), 3U) << run.output;
  EXPECT_EQ(count(run.output, "Ada answers: "), 3U) << run.output;
}

TEST_F(Demo, failsForATaskThatCannotBe) {
  EXPECT_EQ(demoTask("_task:=config/domains/tea/no_such_task.yaml").status, 1);
  // The problem's goal without a plan: it is not what the person expects.
  const Telling run = demoTask("_task:=test/ros/models/empty_task.yaml");
  EXPECT_EQ(run.status, 1) << run.output;
  EXPECT_NE(run.output.find("(outcome 72)"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("Guaranteed:"), std::string::npos) << run.output;
}

TEST_F(Demo, canBeDoneWithTheClientInPython) {
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
  ASSERT_NO_FATAL_FAILURE(forgetWhatWasDone());
  EXPECT_EQ(told("/usr/bin/python3 " + client + " '(tea-served)'").status, 1)
      << "it is not planned";
}

// A task of config/domains/home in its namespace.
struct HomeTask {
  std::string name;
  std::size_t questions;
  std::vector<std::string> parts;  // of what is told

  friend std::ostream& operator<<(std::ostream& out, const HomeTask& task) {
    return out << task.name;
  }
};

class HomeDemo : public testing::TestWithParam<HomeTask> {};

TEST_P(HomeDemo, isToldAndCarriedOut) {
  const HomeTask& task = GetParam();
  const std::string domain = "config/domains/home";
  const Telling run = demoTask("__ns:=/" + task.name + " _task:=" + domain + "/" + task.name +
                               "/task.yaml _phrases:=" + domain + "/phrases.yaml");
  std::vector<std::string> parts = task.parts;
  parts.insert(parts.begin(), "Where this plan breaks for the robot: ");
  parts.insert(parts.end(), "\nGuaranteed: ");
  expectInOrder(run, parts);
  EXPECT_EQ(count(run.output, "The robot asks: "), task.questions) << run.output;
}

INSTANTIATE_TEST_SUITE_P(
    Tasks, HomeDemo,
    testing::Values(
        HomeTask{"clear_table", 0, {"The robot has a plan of 20 steps", "  step 1 of 20: "}},
        HomeTask{"nap_time",
                 2,
                 {"oes it matter to you that little Leo goes on sleeping?", "Ada answers: yes",
                  "the carpet in the living room is clean?", "Ada answers: no",
                  "Left out: the carpet in the living room"}},
        HomeTask{"evening_tablets",
                 2,
                 {"oes it matter to you that Grace stays in the bedroom?", "Ada answers: yes",
                  "oes it matter to you that Grace takes the evening dose?", "Ada answers: yes",
                  "There is no plan (outcome 52): ", "That is certain.",
                  "I can do everything except: Grace stays in the bedroom.",
                  "Ada settles for everything except: Grace stays in the bedroom.",
                  "The robot has a plan of 17 steps",
                  "  step 1 of 17: ", "ring the bell, so that Grace comes into the hall"}},
        HomeTask{
            "laundry_day",
            1,
            {"hich of these matter to you: ", "the school shirt hangs on the clothes horse: yes"}},
        HomeTask{"afternoon_tea",
                 2,
                 {"Grace gets the pair of reading glasses?", "Ben answers: no",
                  "the bunch of car keys is on the hall table?", "Ben answers: no",
                  "The robot has a plan of 25 steps", "  step 1 of 25: "}},
        HomeTask{"lay_table",
                 1,
                 {"the tray of crystal glasses is on the dining table?", "Ada answers: no",
                  "The robot has a plan of 15 steps", "step 1 of 15: open the dining room door",
                  "Something went wrong: ",
                  "The robot has a new plan of 25 steps, under the same answers"}}),
    [](const auto& home_task) { return home_task.param.name; });

}  // namespace
}  // namespace goal_alignment::test
