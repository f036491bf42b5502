// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <set>
#include <string>
#include <vector>

#include "program.h"

/// `hagl align`, as a user runs it.
namespace goal_alignment::cli {
namespace {

using nlohmann::json;
using samples::Ended;
using samples::Folder;
using samples::hagl;
using samples::Program;
using samples::writeDesk;

std::set<std::string> keys(const json& object) {
  std::set<std::string> result;
  for (const auto& [key, value] : object.items())
    result.insert(key);
  return result;
}

std::vector<std::string> strings(const json& list) {
  return list;
}

TEST(Align, PlanFound) {
  const Folder folder;
  writeDesk(folder, "(down b)\n(held a) ; what is really wanted\n");
  const Ended ended = hagl({"align", folder.path(), "--json"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const json found = ended.json();
  EXPECT_EQ(keys(found),
            (std::set<std::string>{"outcome", "code", "message", "plan", "cost", "optimal",
                                   "guaranteed", "kept_unasked", "extra_cost", "not_wanted",
                                   "candidates", "candidates_static", "questions", "rounds",
                                   "planner_calls", "timing"}));
  EXPECT_EQ(found["outcome"], "plan_found");
  EXPECT_EQ(found["code"], 1);
  EXPECT_EQ(strings(found["plan"]), std::vector<std::string>{"(take a)"});
  EXPECT_EQ(found["cost"], 1);
  EXPECT_EQ(found["optimal"], false);
  EXPECT_EQ(strings(found["guaranteed"]), (std::vector<std::string>{"(down b)", "(held a)"}));
  EXPECT_EQ(strings(found["not_wanted"]),
            (std::vector<std::string>{"(down a)", "(free)", "(held b)"}));
  EXPECT_EQ(strings(found["kept_unasked"]), (std::vector<std::string>{"(down c)", "(red a)"}));
  EXPECT_EQ(found["candidates"], 6);
  EXPECT_EQ(found["candidates_static"], 1);
  EXPECT_EQ(found["rounds"], 4);
  EXPECT_EQ(keys(found["timing"]), (std::set<std::string>{"parse", "ground", "belief", "conflicts",
                                                          "questions", "plan", "total"}));
  ASSERT_EQ(found["questions"].size(), 4U);
  const json first = found["questions"][0];
  EXPECT_EQ(keys(first), (std::set<std::string>{"fluent", "answer", "round", "why"}));
  EXPECT_EQ(first["fluent"], "(held b)");
  EXPECT_EQ(first["answer"], "no");
  EXPECT_EQ(first["round"], 1);
  EXPECT_NE(first["why"].get<std::string>().find("(held b)"), std::string::npos);
}

TEST(Align, NoPlan) {
  const Folder folder;
  writeDesk(folder, "(down b)\n(held a)\n(free)\n");
  const Ended ended = hagl({"align", folder.path(), "--json"});
  EXPECT_EQ(ended.status, 1);
  const json found = ended.json();
  EXPECT_EQ(found["outcome"], "no_plan");
  EXPECT_EQ(found["code"], 52);
  EXPECT_EQ(strings(found["conflict"]), (std::vector<std::string>{"(free)", "(held a)"}));
  EXPECT_EQ(found["conflict_proven"], true);
  EXPECT_EQ(found["conflict_minimal"], true);
  ASSERT_EQ(found["alternatives"].size(), 2U);
  EXPECT_EQ(keys(found["alternatives"][0]), (std::set<std::string>{"given_up", "probability"}));
  EXPECT_FALSE(found.contains("plan"));
}

TEST(Align, WhatWasAnsweredYesIsHardlyGivenUp) {
  const Folder folder;
  writeDesk(folder, "(down b)\n(held a)\n(free)\n");
  const json found = hagl({"align", folder.path(), "--json"}).json();
  double last = 0.02;
  for (const json& alternative : found["alternatives"]) {
    const double probability = alternative["probability"];
    EXPECT_GT(probability, 0);
    EXPECT_LE(probability, last);
    last = probability;
  }
}

TEST(Align, AllThatWasShownInAGroupIsListed) {
  const Folder folder;
  writeDesk(folder, "(down b)\n(held b)\n");  // which can't be had: the rest is needless
  const Ended ended = hagl({"align", folder.path(), "--group", "6", "--json"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  const json questions = ended.json()["questions"];
  EXPECT_EQ(ended.json()["rounds"], 1);
  EXPECT_GE(questions.size(), 3U);
  for (const json& question : questions) {
    EXPECT_EQ(question["round"], 1);
    EXPECT_EQ(question["answer"], question["fluent"] == "(held b)" ? "yes" : "no");
    EXPECT_TRUE(question.contains("why"));
  }
}

TEST(Align, UnsolvableSpecifiedGoal) {
  const Folder folder;
  writeDesk(folder, "(down b)\n");
  // The robot can't put anything down that it holds: nothing is held and down.
  for (const char* file : {"robot_problem.pddl", "human_problem.pddl"}) {
    std::string problem = folder.read(file);
    const std::string goal = "(:goal (down b))";
    folder.write(
        file, problem.replace(problem.find(goal), goal.size(), "(:goal (and (down b) (held b)))"));
  }
  const Ended ended = hagl({"align", folder.path(), "--json"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(ended.json()["code"], 51);
  EXPECT_EQ(ended.json()["conflict"], json::array());
  EXPECT_EQ(ended.json()["conflict_proven"], true);
}

TEST(Align, InvalidInputIsJsonToo) {
  const Folder folder;
  writeDesk(folder, "(down b)\n");
  folder.write("human_plan.txt", "(take a)\n(put b)\n");
  Ended ended = hagl({"align", folder.path(), "--json"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.json()["outcome"], "invalid");
  EXPECT_EQ(ended.json()["code"], 71);
  EXPECT_FALSE(ended.json().contains("plan"));
  folder.write("human_plan.txt", "(take a\n");  // fails before there is a session
  ended = hagl({"align", folder.path(), "--json"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.json()["code"], 70);
  EXPECT_NE(ended.json()["message"].get<std::string>().find("human_plan.txt:"), std::string::npos);
  folder.write("human_plan.txt", "");
  folder.write("robot_domain.pddl", "(define");
  ended = hagl({"align", folder.path()});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE((ended.out + ended.err).find("robot_domain.pddl:1:"), std::string::npos) << ended.err;
}

TEST(Align, FilesMayBeNamedOneByOne) {
  const Folder folder;
  writeDesk(folder, "(down b)\n(held a)\n");
  const std::vector<std::string> files = {"align",
                                          "--robot-domain",
                                          folder / "robot_domain.pddl",
                                          "--robot-problem",
                                          folder / "robot_problem.pddl",
                                          "--human-domain",
                                          folder / "human_domain.pddl",
                                          "--human-problem",
                                          folder / "human_problem.pddl",
                                          "--human-plan",
                                          folder / "human_plan.txt"};
  std::vector<std::string> with_goal = files;
  with_goal.insert(with_goal.end(), {"--true-goal", folder / "true_goal.txt"});
  EXPECT_EQ(hagl(with_goal).status, 0);
  EXPECT_EQ(hagl(files).status, 3);  // nobody answers
  std::vector<std::string> too_much = with_goal;
  too_much.push_back(folder.path());
  EXPECT_EQ(hagl(too_much).status, 2);
  EXPECT_EQ(hagl({"align", "--robot-domain", folder / "robot_domain.pddl"}).status, 2);
}

TEST(Align, TrueGoalOverridesTheFolders) {
  const Folder folder;
  writeDesk(folder, "(down b)\n(held a)\n");
  folder.write("other.txt", "(down b)\n(held b)\n");
  EXPECT_EQ(hagl({"align", folder.path()}).status, 0);
  EXPECT_EQ(hagl({"align", folder.path(), "--true-goal", folder / "other.txt"}).status, 1);
}

TEST(Align, WithoutAnybodyToAnswerItIsUndecided) {
  const Folder folder;
  writeDesk(folder, "");
  const Ended ended = hagl({"align", folder.path(), "--json"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(ended.json()["code"], 60);
}

TEST(Align, PoliciesAndModesAllGetThere) {
  const Folder folder;
  writeDesk(folder, "(down b)\n(held a)\n");
  for (const char* policy : {"auto", "optimal", "ratio", "paper", "ask-all"}) {
    for (const char* conflicts : {"full", "lazy"}) {
      const Ended ended = hagl({"align", folder.path(), "--policy", policy, "--conflicts",
                                conflicts, "--seed", "3", "--belief", "flat:0.3", "--json"});
      EXPECT_EQ(ended.status, 0) << policy << ' ' << conflicts << ended.err;
    }
  }
  const Ended all = hagl({"align", folder.path(), "--policy", "ask-all", "--json"});
  const Ended fewer =
      hagl({"align", folder.path(), "--policy", "ask-all", "--no-static", "--json"});
  EXPECT_EQ(all.json()["candidates"], 6);
  EXPECT_LE(fewer.json()["rounds"], all.json()["rounds"]);
  for (const char* plan : {"optimal", "anytime"}) {
    const Ended best = hagl({"align", folder.path(), "--plan", plan, "--threads", "2", "--json"});
    EXPECT_EQ(best.json()["optimal"], true) << plan;
  }
}

TEST(Align, ATinyTimeLimitIsUndecided) {
  const Folder folder;
  writeDesk(folder, "(down b)\n");
  const Ended ended = hagl({"align", folder.path(), "--json", "--time-limit", "0.0000001"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(ended.json()["outcome"], "undecided");
  EXPECT_EQ(ended.json()["code"], 53);
}

TEST(Interactive, PromptsOnStderrAndReadsAnswers) {
  const Folder folder;
  writeDesk(folder, "");
  const Ended ended = hagl({"align", folder.path(), "--interactive", "--json"}, "maybe\nno\nN\n");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.json()["rounds"], 2);
  EXPECT_NE(ended.err.find("[y = yes"), std::string::npos);
  EXPECT_NE(ended.err.find("I did not understand"), std::string::npos);
}

TEST(Interactive, YesLeadsToNoPlan) {
  const Folder folder;
  writeDesk(folder, "");
  const Ended ended = hagl({"align", folder.path(), "--interactive", "--json"}, "yes\n");
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(strings(ended.json()["conflict"]), std::vector<std::string>{"(held b)"});
}

TEST(Interactive, DontKnowLeavesItUndecided) {
  const Folder folder;
  writeDesk(folder, "");
  Ended ended = hagl({"align", folder.path(), "--interactive", "--json"}, "?\n");
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(ended.json()["code"], 64);
  EXPECT_EQ(ended.json()["questions"][0]["answer"], "unsure");
  ended = hagl({"align", folder.path(), "--interactive", "--json", "--unsure-policy", "defer"},
               "?\nno\nno\nno\n");
  EXPECT_EQ(ended.status, 0) << ended.out;
}

TEST(Interactive, DontKnowLeavesAChoiceUnderEveryPolicy) {
  const Folder folder;
  writeDesk(folder, "");
  for (const char* policy : {"as-yes", "defer", "abort"}) {
    const std::vector<std::string> command = {"align", folder.path(), "--interactive",
                                              "--unsure-policy", policy};
    std::vector<std::string> as_json = command;
    as_json.emplace_back("--json");
    const json found = hagl(as_json, "?\n?\n").json();
    EXPECT_EQ(found["code"], 64) << policy;
    ASSERT_EQ(found["alternatives"].size(), 2U) << policy;
    const std::vector<std::string> given_up = strings(found["alternatives"][0]["given_up"]);
    EXPECT_EQ(std::count(given_up.begin(), given_up.end(), "(held b)"), 1) << policy;
    EXPECT_EQ(strings(found["conflict"]), std::vector<std::string>{"(held b)"}) << policy;
    const Ended plain = hagl(command, "?\n?\n");
    EXPECT_NE(plain.out.find("; can do everything except"), std::string::npos) << plain.out;
    EXPECT_NE(plain.out.find("depends on (held B)"), std::string::npos) << plain.out;
  }
}

TEST(Interactive, DecliningIsAnAnswer) {
  const Folder folder;
  writeDesk(folder, "");
  Ended ended = hagl({"align", folder.path(), "--interactive", "--json"}, "decline\n");
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(ended.json()["code"], 61);
  EXPECT_EQ(ended.json()["questions"][0]["answer"], "decline");
  ended = hagl({"align", folder.path(), "--interactive"}, "decline\n");
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.out.find("declined"), std::string::npos) << ended.out;
}

TEST(Interactive, TheEndOfInputLeavesItUndecided) {
  const Folder folder;
  writeDesk(folder, "");
  const Ended ended = hagl({"align", folder.path(), "--interactive", "--json"}, "no\n");
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(ended.json()["code"], 60);
  EXPECT_EQ(ended.json()["rounds"], 1);
}

TEST(Interactive, CtrlCWhileAQuestionIsOpenCancels) {
  const Folder folder;
  writeDesk(folder, "");
  Program program({"align", folder.path(), "--interactive", "--json"});
  ASSERT_TRUE(program.says("[y = yes"));
  program.signal(SIGINT);
  const Ended ended = program.waitWithInputOpen();
  EXPECT_EQ(ended.status, 4);
  EXPECT_EQ(ended.json()["outcome"], "canceled");
  EXPECT_EQ(ended.json()["code"], 50);
}

TEST(Align, CtrlCWhileThinkingCancels) {
  const Folder folder;
  samples::writeEndless(folder);
  Program program({"align", folder.path(), "--json"});
  ASSERT_TRUE(program.works());
  program.signal(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.status, 4);
  EXPECT_EQ(ended.json()["code"], 50);
}

TEST(Align, PrintsForPeopleWithoutJson) {
  const Folder folder;
  writeDesk(folder, "(down b)\n(held a)\n");
  const Ended ended = hagl({"align", folder.path()});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("asked (held B): no"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("plan_found"), std::string::npos);
  EXPECT_NE(ended.out.find("\n(take a)\n"), std::string::npos);
}

}  // namespace
}  // namespace goal_alignment::cli
