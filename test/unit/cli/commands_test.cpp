// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <vector>

#include "program.h"
#include "unit/pddl/samples.h"

/// The other commands, and what all of them have in common.
namespace goal_alignment::cli {
namespace {

using nlohmann::json;
using samples::Ended;
using samples::Folder;
using samples::hagl;
using samples::Program;
using samples::writeDesk;

TEST(Usage, ErrorsExitWithTwo) {
  const Folder folder;
  writeDesk(folder, "(down b)\n");
  const std::string dir = folder.path();
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"fly"},
      {"align"},
      {"align", dir, "--fly"},
      {"align", dir, "--policy"},
      {"align", dir, "--policy", "pepper"},
      {"align", dir, "--belief", "strong"},
      {"align", dir, "--belief", "flat:much"},
      {"align", dir, "--belief", "flat:2"},
      {"align", dir, "--beta", "-1"},
      {"align", dir, "--kappa", "0"},
      {"align", dir, "--conflicts", "some"},
      {"align", dir, "--unsure-policy", "as-no"},
      {"align", dir, "--plan", "worst"},
      {"align", dir, "--group", "0"},
      {"align", dir, "--threads", "0"},
      {"align", dir, "--time-limit", "-1"},
      {"align", dir, "--memory-limit", "0"},
      {"align", dir, "--seed", "x"},
      {"align", dir, "--interactive", "--true-goal", dir + "/true_goal.txt"},
      {"align", dir + "/nowhere"},
      {"align", dir, "--true-goal", dir + "/nowhere.txt"},
      {"conflicts"},
      {"conflicts", dir + "/nowhere"},
      {"conflicts", dir, "--time-limit", "-1"},
      {"plan", dir + "/robot_domain.pddl"},
      {"plan", dir + "/robot_domain.pddl", dir + "/nowhere.pddl"},
      {"validate", dir + "/robot_domain.pddl", dir + "/robot_problem.pddl"},
      {"perturb"},
      {"perturb", dir + "/nowhere.pddl"},
      {"perturb", dir + "/human_plan.txt"},
      {"perturb", dir + "/robot_domain.pddl", "--preconditions", "1000"},
      {"perturb", dir + "/robot_domain.pddl", "--deletes", "-1"},
      {"perturb", dir + "/robot_domain.pddl", "-o", dir + "/nowhere/human.pddl"},
      {"bench"},
      {"bench", dir + "/nowhere"},
      {"bench", dir, "--runs", "0"},
      {"bench", dir, "--policy", "pepper"},
      {"bench", dir, "--policy", "auto", "--policy", "pepper"},
      {"bench", dir, "--truth", "mine"},
      {"bench", dir, "--truth", "1.5"},
      {"bench", dir, "--threads", "0"},
      {"bench", dir, "--beta", "-1"},
      {"bench", dir, "--csv", dir + "/nowhere/table.csv"}};
  for (const auto& arguments : wrong) {
    const Ended ended = hagl(arguments);
    std::string line;
    for (const std::string& argument : arguments)
      line += " " + argument;
    EXPECT_EQ(ended.status, 2) << line;
    EXPECT_NE(ended.err, "") << line;
  }
}

TEST(Usage, HelpIsNoError) {
  EXPECT_EQ(hagl({"--help"}).status, 0);
  EXPECT_EQ(hagl({"align", "--help"}).status, 0);
}

TEST(Perturb, AlignsARobotWithAPersonWhoHasForgottenSome) {
  const Folder folder;
  writeDesk(folder, "(down b)\n");
  const std::vector<std::string> words = {
      "perturb", folder / "robot_domain.pddl", "--seed", "3", "--preconditions", "1", "--deletes",
      "0"};
  const Ended shown = hagl(words);
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.err.find("forgotten: precondition ("), 0U) << shown.err;
  EXPECT_NE(shown.out, folder.read("robot_domain.pddl"));

  std::vector<std::string> into_file = words;
  into_file.insert(into_file.end(), {"-o", folder / "human_domain.pddl"});
  const Ended written = hagl(into_file);
  EXPECT_EQ(written.status, 0);
  EXPECT_EQ(written.out, "");
  EXPECT_EQ(written.err, shown.err);
  EXPECT_EQ(folder.read("human_domain.pddl"), shown.out);
  // Who has forgotten a precondition can still do what can be done.
  EXPECT_EQ(hagl({"plan", folder / "human_domain.pddl", folder / "human_problem.pddl"}).status, 0);
}

TEST(Conflicts, AreListedSortedAndComplete) {
  const Folder folder;
  writeDesk(folder, "");
  const Ended ended = hagl({"conflicts", folder.path(), "--json"});
  EXPECT_EQ(ended.status, 0);
  const json expected = json::parse(R"json({"complete": true, "conflicts": [
      {"fluents": ["(down a)", "(held a)"], "proven": true, "minimal": true},
      {"fluents": ["(free)", "(held a)"], "proven": true, "minimal": true},
      {"fluents": ["(held b)"], "proven": true, "minimal": true}]})json");
  EXPECT_EQ(ended.json(), expected);
  const Ended text = hagl({"conflicts", folder.path()});
  EXPECT_NE(text.out.find("(free) (held a)"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("complete"), std::string::npos);
}

TEST(Conflicts, AnUnsolvableGoalIsOneEmptyConflict) {
  const Folder folder;
  writeDesk(folder, "");
  std::string domain = folder.read("robot_domain.pddl");
  folder.write("robot_domain.pddl", domain.replace(domain.find("(held ?x) (not (free))"), 9, ""));
  for (const char* file : {"robot_problem.pddl", "human_problem.pddl"}) {
    std::string problem = folder.read(file);
    folder.write(file, problem.replace(problem.find("(:goal (down b))"), 16, "(:goal (held b))"));
  }
  const Ended ended = hagl({"conflicts", folder.path(), "--json"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  ASSERT_EQ(ended.json()["conflicts"].size(), 1U);
  EXPECT_EQ(ended.json()["conflicts"][0]["fluents"], json::array());
}

TEST(Conflicts, IncompleteOnesExitWithThree) {
  const Folder folder;
  samples::writeEndless(folder);
  const Ended ended = hagl({"conflicts", folder.path(), "--json", "--time-limit", "0.3"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(ended.json()["complete"], false);
}

TEST(Conflicts, CtrlCCancels) {
  const Folder folder;
  samples::writeEndless(folder);
  Program program({"conflicts", folder.path()});
  ASSERT_TRUE(program.works());
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().status, 4);
}

class PlanCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("d.pddl", pddl::samples::kTeaDomain);
    folder_.write("p.pddl", pddl::samples::kTeaProblem);
  }
  std::vector<std::string> plan(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {"plan", folder_ / "d.pddl", folder_ / "p.pddl"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Folder folder_;
};

TEST_F(PlanCommand, OptimalMinimisesTheMetric) {
  const Ended ended = hagl(plan({"--optimal", "--json"}));
  EXPECT_EQ(ended.status, 0) << ended.err;
  const json found = ended.json();
  EXPECT_EQ(found["outcome"], "plan_found");
  EXPECT_EQ(found["cost"], 8);  // carry the pot 3, heat 5, pour 0
  EXPECT_EQ(found["optimal"], true);
  EXPECT_EQ(found["plan"].size(), 3U);
  for (const char* field : {"expanded", "evaluated", "peak_mib"}) {
    EXPECT_TRUE(found[field].is_number()) << field;
  }
  for (const char* phase : {"parse", "ground", "search", "total"}) {
    EXPECT_TRUE(found["timing"][phase].is_number()) << phase;
  }
  EXPECT_EQ(hagl(plan({"--json"})).json()["optimal"], false);
}

TEST_F(PlanCommand, PrintsAPlanThatValidateAccepts) {
  const Ended ended = hagl(plan({}));
  EXPECT_EQ(ended.status, 0);
  folder_.write("plan.txt", ended.out);
  const Ended valid =
      hagl({"validate", folder_ / "d.pddl", folder_ / "p.pddl", folder_ / "plan.txt"});
  EXPECT_EQ(valid.status, 0) << valid.out;
  EXPECT_NE(valid.out.find("valid, 3 steps, cost 8"), std::string::npos) << valid.out;
}

TEST_F(PlanCommand, AnUnsolvableTaskExitsWithOne) {
  folder_.write("p.pddl", pddl::samples::with(pddl::samples::kTeaProblem, "(HandEmpty) ", ""));
  const Ended ended = hagl(plan({"--json"}));
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(ended.json()["outcome"], "no_plan");
  EXPECT_FALSE(ended.json().contains("plan"));
}

TEST_F(PlanCommand, BrokenPddlExitsWithTwoAndItsPlace) {
  folder_.write("p.pddl", "(define (problem p)\n (:domain tea) (:oops))");
  const Ended ended = hagl(plan({}));
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("p.pddl:2:"), std::string::npos) << ended.err;
}

TEST_F(PlanCommand, LimitsExitWithThree) {
  samples::writeEndlessTask(folder_);
  for (const std::string mode : {"--json", "--optimal"}) {
    EXPECT_EQ(hagl(plan({"--time-limit", "0.2", "--json", mode})).status, 3) << mode;
  }
  const Ended memory = hagl(plan({"--memory-limit", "1", "--json"}));
  EXPECT_EQ(memory.status, 3);
  EXPECT_EQ(memory.json()["outcome"], "undecided");
}

TEST_F(PlanCommand, CtrlCExitsWithFour) {
  samples::writeEndlessTask(folder_);
  Program program(plan({"--json"}));
  ASSERT_TRUE(program.works());
  program.signal(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.status, 4);
  EXPECT_EQ(ended.json()["outcome"], "cancelled");
}

TEST_F(PlanCommand, ValidateNamesWhatIsWrong) {
  folder_.write("plan.txt", "(heat pot)\n");
  const Ended ended =
      hagl({"validate", folder_ / "d.pddl", folder_ / "p.pddl", folder_ / "plan.txt"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.out.find("(at Pot Table)"), std::string::npos) << ended.out;
}

}  // namespace
}  // namespace goal_alignment::cli
