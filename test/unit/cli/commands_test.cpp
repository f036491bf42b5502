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

TEST(Usage, WhoeverReadsJsonGetsAnObjectWhateverHappens) {
  const Folder folder;
  writeDesk(folder, "(down b)\n");
  const std::string dir = folder.path();
  const std::string domain = dir + "/robot_domain.pddl";
  const std::string problem = dir + "/robot_problem.pddl";
  folder.write("broken.pddl", "(define (problem p)\n (:domain desk) (:oops))");
  folder.write("empty/note.txt", "");
  const std::string broken = dir + "/broken.pddl";
  const std::string broken_place = broken + ":2:18: expected";
  const std::string none = dir + "/none.pddl";
  struct Case {
    std::vector<std::string> arguments;
    std::string in_message;
  };
  const std::vector<Case> cases = {
      {{"plan", domain, broken, "--json"}, broken_place},
      {{"plan", "--json", domain, none}, none + ": can't be read: no such file"},
      {{"plan", domain, "--json"}, "PROBLEM is required"},
      {{"plan", domain, problem, "--json", "--time-limit", "soon"}, "soon"},
      {{"plan", domain, problem, "--json", "--fly"}, "--fly"},
      {{"validate", domain, broken, none, "--json"}, broken_place},
      {{"validate", domain, problem, none, "--json"}, none},
      {{"validate", domain, problem, broken, "--json"}, broken + ":1:9: expected an object"},
      {{"conflicts", dir + "/nowhere", "--json"}, "expected an instance folder"},
      {{"conflicts", dir + "/empty/below", "--json"}, "expected an instance folder"},
      {{"conflicts", "--json"}, "DIR is required"},
      {{"perturb", broken, "--json"}, broken + ":1:10: expected 'domain'"},
      {{"perturb", domain, "--preconditions", "1000", "--json"}, "can't forget 1000 preconditions"},
      {{"perturb", domain, "-o", dir + "/nowhere/human.pddl", "--json"}, "can't be written"},
      {{"align", dir, "--policy", "pepper", "--json"}, "pepper"},
      {{"align", dir + "/nowhere", "--json"}, "expected an instance folder"},
      {{"--json"}, "subcommand is required"}};
  for (const Case& fault : cases) {
    const Ended ended = hagl(fault.arguments);
    SCOPED_TRACE(fault.in_message + ended.err);
    EXPECT_EQ(ended.status, 2);
    ASSERT_NE(ended.out, "");
    const json object = ended.json();
    EXPECT_EQ(object.at("outcome"), "invalid");
    EXPECT_EQ(object.at("code"), 70);
    EXPECT_NE(object.at("message").get<std::string>().find(fault.in_message), std::string::npos)
        << object;
    EXPECT_NE(ended.err, "") << "people are told as well";
  }
  EXPECT_EQ(hagl({"plan", "none\xff.pddl", problem, "--json"}).json().at("outcome"), "invalid");
  EXPECT_EQ(hagl({"plan", domain, broken}).out, "");
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

TEST(Perturb, ListsWhatIsForgottenInJson) {
  const Folder folder;
  writeDesk(folder, "");
  const std::vector<std::string> words = {"perturb", folder / "robot_domain.pddl", "--seed", "3"};
  std::vector<std::string> in_json = words;
  in_json.emplace_back("--json");
  const json found = hagl(in_json).json();
  EXPECT_EQ(found.at("forgotten").size(), 2U);
  EXPECT_EQ(found.at("domain"), hagl(words).out);
  in_json.insert(in_json.end(), {"-o", folder / "human_domain.pddl"});
  EXPECT_EQ(hagl(in_json).json(), (json{{"forgotten", found.at("forgotten")}}));
  EXPECT_EQ(folder.read("human_domain.pddl"), found.at("domain"));
}

TEST(Perturb, RefusesWhatPlanRefuses) {
  const Folder folder;
  folder.write(
      "d.pddl",
      "(define (domain d)\n (:predicates (in ?r - robot))\n"
      " (:action a :parameters (?r - robot) :precondition (in ?r) :effect (not (in ?r))))");
  folder.write("p.pddl", "(define (problem p) (:domain d) (:objects r - robot) (:goal (in r)))");
  const Ended perturbed = hagl({"perturb", folder / "d.pddl"});
  EXPECT_EQ(perturbed.status, 2);
  EXPECT_EQ(perturbed.out, "");
  EXPECT_EQ(perturbed.err, hagl({"plan", folder / "d.pddl", folder / "p.pddl"}).err);
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

TEST_F(PlanCommand, SeveralCostsAddUp) {
  folder_.write("d.pddl",
                pddl::samples::with(pddl::samples::kTeaDomain, "(increase (total-cost) 5)",
                                    "(increase (total-cost) 5) (increase (total-cost) "
                                    "(way table shelf)) (increase (total-cost) 1)"));
  folder_.write("p.pddl", pddl::samples::kTeaProblem);
  const Ended ended = hagl(plan({"--optimal"}));
  EXPECT_NE(ended.out.find("cost 13"), std::string::npos) << ended.out << ended.err;
  folder_.write("plan.txt", ended.out);
  EXPECT_EQ(hagl({"validate", folder_ / "d.pddl", folder_ / "p.pddl", folder_ / "plan.txt"}).out,
            "valid, 3 steps, cost 13\n");
}

TEST_F(PlanCommand, ValidateReadsAPlanFromAPipeInAnyForm) {
  const std::string printed =
      "ff: found legal plan as follows\r\n\r\nstep    0: MOVE POT SHELF TABLE\r\n"
      "        1: HEAT POT\r\n        2: POUR POT MUG\r\n\r\ntime spent:    0.00 seconds in "
      "all\r\n";
  const std::vector<std::string> validate = {"validate", folder_ / "d.pddl", folder_ / "p.pddl",
                                             "/dev/stdin"};
  for (const std::string& text :
       {printed, std::string("move(pot, shelf, table)\nheat(pot)\npour(pot,mug)\n"),
        std::string(
            "0.000: (move pot shelf table) [1.000]\n1.0: (heat pot) [1]\n2: (pour pot mug)")}) {
    const Ended ended = hagl(validate, text);
    EXPECT_EQ(ended.out, "valid, 3 steps, cost 8\n") << text << ended.err;
  }
  std::vector<std::string> in_json = validate;
  in_json.emplace_back("--json");
  EXPECT_EQ(hagl(in_json, printed).json(), (json{{"outcome", "valid"}, {"steps", 3}, {"cost", 8}}));
  const Ended invalid = hagl(in_json, "heat(pot)\n");
  EXPECT_EQ(invalid.status, 2);
  EXPECT_EQ(invalid.json().at("outcome"), "invalid");
  EXPECT_EQ(invalid.json().at("code"), 71);
  EXPECT_NE(invalid.json().at("message").get<std::string>().find("(at Pot Table)"),
            std::string::npos);
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
  EXPECT_EQ(ended.json()["outcome"], "canceled");
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
