// SPDX-License-Identifier: BSD-3-Clause
// The tasks of config/domains/home, as `hagl align` treats them.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "goal_alignment/cli/instance.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"
#include "program.h"
#include "unit/source_root.h"

namespace goal_alignment::cli {
namespace {

using nlohmann::json;
using samples::Ended;
using samples::Folder;
using samples::hagl;

using Answers = std::map<std::string, std::string>;  // by fluent

struct HomeTask {
  std::string name;
  int code = 1;
  int rounds = 0;
  Answers answers;

  friend std::ostream& operator<<(std::ostream& out, const HomeTask& task) {
    return out << task.name;
  }
};

std::string homeFolder() {
  return (sourceRoot() / "config/domains/home").string();
}

// The options that say what the task's node parameters do.
std::vector<std::string> optionsOf(const std::string& folder) {
  const std::map<std::string, std::string> words = {{"max_group_size", "--group"},
                                                    {"kappa", "--kappa"},
                                                    {"plan", "--plan"},
                                                    {"conflicts", "--conflicts"}};
  std::vector<std::string> options;
  for (const auto& entry : YAML::LoadFile(folder + "/parameters.yaml")) {
    const auto key = entry.first.as<std::string>();
    if (key == "negative_candidates") {
      if (entry.second.as<bool>()) options.emplace_back("--negative-candidates");
    } else {
      options.insert(options.end(), {words.at(key), entry.second.as<std::string>()});
    }
  }
  return options;
}

class Home : public testing::TestWithParam<HomeTask> {
 protected:
  std::string folder_ = homeFolder() + "/" + GetParam().name;

  json align(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"align", folder_, "--json"};
    for (const auto& options : {optionsOf(folder_), more})
      arguments.insert(arguments.end(), options.begin(), options.end());
    return hagl(arguments).json();
  }

  void expectValid(const json& plan) const {
    const Folder scratch;
    std::string text;
    for (const auto& step : plan)
      text += step.get<std::string>() + "\n";
    scratch.write("plan.txt", text);
    const InstanceFiles files = InstanceFiles::of(folder_);
    const Ended ended =
        hagl({"validate", files.robot_domain, files.robot_problem, scratch / "plan.txt"});
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  }
};

TEST_P(Home, EndsAsItIsMeantToWithFewQuestions) {
  const json found = align();
  EXPECT_EQ(found["code"], GetParam().code) << found;
  EXPECT_EQ(found["rounds"], GetParam().rounds) << found;
  Answers answers;
  for (const json& question : found["questions"])
    answers.emplace(question["fluent"], question["answer"]);
  EXPECT_EQ(answers, GetParam().answers);
}

TEST_P(Home, ItsPlanIsValidAndOfALengthThatPeopleFollow) {
  const json found = align();
  if (GetParam().code != 1) return;
  expectValid(found["plan"]);
  EXPECT_GE(found["plan"].size(), 8U);
  EXPECT_LE(found["plan"].size(), 26U);
}

TEST_P(Home, ThePersonsPlanIsValidForThemAndNotForTheRobot) {
  const InstanceFiles files = InstanceFiles::of(folder_);
  EXPECT_EQ(hagl({"validate", files.human_domain, files.human_problem, files.human_plan}).status,
            0);
  EXPECT_NE(hagl({"validate", files.robot_domain, files.robot_problem, files.human_plan}).status,
            0);
}

TEST_P(Home, IsRich) {
  const InstanceFiles files = InstanceFiles::of(folder_);
  const pddl::Model model =
      pddl::readModel(pddl::readFile(files.robot_domain), pddl::readFile(files.robot_problem));
  EXPECT_GE(model.objects.size(), 20U);
  EXPECT_GE(pddl::parsePlan(pddl::readFile(files.human_plan)).steps.size(), 8U);
}

INSTANTIATE_TEST_SUITE_P(
    Tasks, Home,
    testing::Values(
        HomeTask{"clear_table", 1, 0, {}},
        HomeTask{
            "nap_time", 1, 2, {{"(not (awake leo))", "yes"}, {"(carpet-clean living-room)", "no"}}},
        HomeTask{"evening_tablets",
                 52,
                 2,
                 {{"(person-in grace bedroom)", "yes"}, {"(taken tablets grace)", "yes"}}},
        HomeTask{"laundry_day",
                 1,
                 1,
                 {{"(hung school-shirt clothes-horse)", "yes"},
                  {"(hung sports-shirt clothes-horse)", "no"},
                  {"(hung towel clothes-horse)", "no"},
                  {"(hung tablecloth clothes-horse)", "no"}}},
        HomeTask{"afternoon_tea",
                 1,
                 2,
                 {{"(given reading-glasses grace)", "no"}, {"(on car-keys hall-table)", "no"}}},
        HomeTask{"lay_table", 1, 1, {{"(on crystal-glasses dining-table)", "no"}}}),
    [](const auto& task) { return task.param.name; });

TEST(HomeAlternatives, TheBestOneIsThatGraceComesDown) {
  const Ended ended = hagl({"align", homeFolder() + "/evening_tablets", "--json"});
  const json alternatives = ended.json()["alternatives"];
  ASSERT_EQ(alternatives.size(), 2U);
  EXPECT_EQ(alternatives[0]["given_up"], json::array({"(person-in grace bedroom)"}));
  EXPECT_EQ(alternatives[1]["given_up"], json::array({"(taken tablets grace)"}));
  EXPECT_GE(alternatives[0]["probability"], alternatives[1]["probability"]);
}

// The robot gets stuck at the jammed door when nothing is done yet; nobody has to be asked again.
TEST(HomeDetour, ThereIsAWayRoundTheJammedDoor) {
  const InstanceFiles files = InstanceFiles::of(homeFolder() + "/lay_table");
  std::string problem = pddl::readFile(files.robot_problem).text;
  problem.replace(problem.find("(:init"), 6, "(:init (jammed dining-door)");
  const Folder folder;
  folder.write("robot_problem.pddl", problem);
  const Ended ended = hagl({"align", "--robot-domain", files.robot_domain, "--robot-problem",
                            folder / "robot_problem.pddl", "--human-domain", files.human_domain,
                            "--human-problem", files.human_problem, "--human-plan",
                            files.human_plan, "--true-goal", files.true_goal, "--json"});
  EXPECT_EQ(ended.status, 0) << ended.out;
  EXPECT_EQ(ended.json()["rounds"], 1);
}

}  // namespace
}  // namespace goal_alignment::cli
