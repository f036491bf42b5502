// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <set>
#include <string>
#include <vector>

#include "program.h"
#include "unit/cli/xml.h"

/// `hagl bench`, as a user runs it.
namespace goal_alignment::cli {
namespace {

using nlohmann::json;
using samples::Ended;
using samples::Folder;
using samples::hagl;
using samples::Program;
using samples::writeDesk;

Ended bench(const Folder& root, const std::vector<std::string>& more) {
  std::vector<std::string> all = {"bench", root.path()};
  all.insert(all.end(), more.begin(), more.end());
  return hagl(all);
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::stringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/// No two runs share the times.
bool isTime(const std::string& field) {
  return field.find("seconds") == 0 || field.find("first_question") == 0 ||
         field.find("per_answer") == 0;
}

json withoutTimes(json rows) {
  for (json& row : rows) {
    for (auto field = row.begin(); field != row.end();)
      field = isTime(field.key()) ? row.erase(field) : std::next(field);
  }
  return rows;
}

/// The cells of a table without quotes, but for the times.
std::vector<std::string> untimed(const std::string& csv) {
  std::vector<std::string> names;
  std::vector<std::string> cells;
  for (const std::string& line : linesOf(csv)) {
    std::stringstream stream(line);
    std::size_t column = 0;
    for (std::string cell; std::getline(stream, cell, ','); ++column) {
      if (names.size() <= column) names.push_back(cell);
      if (!isTime(names[column])) cells.push_back(cell);
    }
  }
  return cells;
}

TEST(Bench, AlignsEveryInstanceBelowAFolder) {
  const Folder root;
  writeDesk(root, "(down b)\n(held a)\n", "one/");
  writeDesk(root, "(down b)\n(held b)\n", "two/deeper/");
  const Ended ended = bench(root, {"--policy", "auto", "--policy", "paper", "--runs", "3",
                                   "--truth", "own", "--json", "--csv", root / "table.csv"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const json rows = ended.json();
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0]["instance"], "one");
  EXPECT_EQ(rows[0]["policy"], "auto");
  EXPECT_EQ(rows[0]["questions_mean"], 4.0);
  EXPECT_EQ(rows[0]["outcome"], "plan_found");
  EXPECT_EQ(rows[2]["outcome"], "no_plan");
  const std::string csv = root.read("table.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_NE(csv.find("deeper,paper"), std::string::npos) << csv;
}

TEST(Bench, AnInstanceThatDoesNotRunIsAFailure) {
  const Folder root;
  writeDesk(root, "(down b)\n", "good/");
  writeDesk(root, "(down b)\n", "bad/");
  root.write("bad/true_goal.txt", "(down");
  const Ended ended = bench(root, {"--runs", "1"});
  EXPECT_NE(ended.status, 0);
  EXPECT_NE(ended.out.find("good"), std::string::npos);
  EXPECT_NE(ended.out.find("error"), std::string::npos);
}

TEST(Bench, MeasuresUnderThreeTruthsWithAllFields) {
  const Folder root;
  writeDesk(root, "(down b)\n(held a)\n", "desk/");
  const Ended ended = bench(root, {"--runs", "2", "--json", "--csv", root / "table.csv"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const json rows = ended.json();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0]["truth"], "own");
  EXPECT_EQ(rows[1]["truth"], "0.2");
  EXPECT_EQ(rows[2]["truth"], "0.5");
  const std::vector<std::string> fields = {"instance",
                                           "policy",
                                           "truth",
                                           "runs",
                                           "candidates",
                                           "candidates_static",
                                           "settled_unasked",
                                           "questions_mean",
                                           "questions_std",
                                           "rounds_mean",
                                           "rounds_max",
                                           "minimum_mean",
                                           "gap_minimum",
                                           "optimal_mean",
                                           "gap_optimal",
                                           "first_question_mean",
                                           "first_question_max",
                                           "per_answer_mean",
                                           "per_answer_max",
                                           "seconds_mean",
                                           "seconds_parse",
                                           "seconds_ground",
                                           "seconds_belief",
                                           "seconds_conflicts",
                                           "seconds_questions",
                                           "seconds_plan",
                                           "planner_calls_mean",
                                           "outcome"};
  const auto in_order = nlohmann::ordered_json::parse(ended.out);
  std::string header;
  std::vector<std::string> names;
  for (const auto& [name, value] : in_order[0].items()) {
    names.push_back(name);
    header += (header.empty() ? "" : ",") + name;
  }
  EXPECT_EQ(names, fields);
  const std::vector<std::string> csv = linesOf(root.read("table.csv"));
  ASSERT_EQ(csv.size(), 4U);
  EXPECT_EQ(csv[0], header);
  EXPECT_EQ(csv[1].rfind("desk,auto,own,2,6,1,", 0), 0U) << csv[1];
}

// The conflicts are {held b}, {held a, free}, {held a, down a}; held a is wanted.
TEST(Bench, ComparesWithTheClairvoyantAndTheOptimum) {
  const Folder root;
  writeDesk(root, "(down b)\n(held a)\n", "desk/");
  const json rows = bench(root, {"--policy", "auto", "--policy", "ask-all", "--policy", "optimal",
                                 "--truth", "own", "--runs", "2", "--json"})
                        .json();
  ASSERT_EQ(rows.size(), 3U);
  const json& own = rows[0];
  EXPECT_EQ(own["minimum_mean"], 3.0);
  EXPECT_DOUBLE_EQ(own["gap_minimum"], 4.0 / 3 - 1);
  EXPECT_DOUBLE_EQ(own["settled_unasked"], 2.0 / 6);
  EXPECT_EQ(own["rounds_max"], 4.0);
  EXPECT_EQ(own["optimal_mean"], rows[2]["questions_mean"]);
  EXPECT_EQ(own["gap_optimal"], 0.0);
  const double all = rows[1]["questions_mean"];
  EXPECT_DOUBLE_EQ(rows[1]["gap_optimal"], all / own["optimal_mean"].get<double>() - 1);
}

TEST(Bench, OptimalIsTheReferenceWithoutARowOfItsOwn) {
  const Folder root;
  writeDesk(root, "(down b)\n", "desk/");
  const json rows =
      bench(root, {"--policy", "paper", "--truth", "own", "--runs", "1", "--json"}).json();
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["policy"], "paper");
  EXPECT_TRUE(rows[0].contains("gap_optimal"));
}

TEST(Bench, EveryPolicySeesTheSameTruths) {
  const Folder root;
  writeDesk(root, "(down b)\n", "desk/");
  const std::vector<std::string> all = {"--policy", "auto",    "--policy", "paper",
                                        "--policy", "ask-all", "--truth",  "0.5",
                                        "--runs",   "12",      "--json"};
  const json rows = bench(root, all).json();
  ASSERT_EQ(rows.size(), 3U);
  for (const json& row : rows) {
    EXPECT_EQ(row["minimum_mean"], rows[0]["minimum_mean"]);
    EXPECT_EQ(row["optimal_mean"], rows[0]["optimal_mean"]);
    EXPECT_EQ(row["outcome"], rows[0]["outcome"]);  // how often there is a plan
    EXPECT_GE(row["questions_mean"], row["minimum_mean"]);
  }
  std::vector<std::string> other = all;
  other.insert(other.end(), {"--seed", "1000"});
  EXPECT_NE(bench(root, other).json()[0], rows[0]);
}

TEST(Bench, TheNumberOfThreadsChangesTimesAlone) {
  const Folder root;
  for (const std::string name : {"a", "b", "c", "d"})
    writeDesk(root, "(down b)\n(held " + std::string(name < "c" ? "a" : "b") + ")\n", name + "/");
  const auto rows = [&](const std::string& threads) {
    const std::string csv = root / ("table" + threads + ".csv");
    const Ended ended = bench(root, {"--policy", "auto", "--policy", "paper", "--runs", "3",
                                     "--json", "--threads", threads, "--csv", csv});
    EXPECT_EQ(ended.status, 0) << ended.err;
    return withoutTimes(ended.json());
  };
  const json one = rows("1");
  EXPECT_EQ(one.size(), 24U);
  EXPECT_EQ(rows("3"), one);
  EXPECT_EQ(untimed(root.read("table3.csv")), untimed(root.read("table1.csv")));
}

TEST(Bench, WithoutATrueGoalThereAreTheDrawnTruths) {
  const Folder root;
  writeDesk(root, "", "desk/");
  const Ended ended = bench(root, {"--runs", "1", "--json"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.err.find("desk: no true_goal.txt"), std::string::npos) << ended.err;
  ASSERT_EQ(ended.json().size(), 2U);
  EXPECT_EQ(ended.json()[0]["truth"], "0.2");
  const Ended none = bench(root, {"--runs", "1", "--truth", "own"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.out.find("error: no true_goal.txt"), std::string::npos) << none.out;
}

TEST(Bench, AModelThatIsInvalidIsAnErrorOfItsRows) {
  const Folder root;
  writeDesk(root, "(down b)\n", "a/");
  writeDesk(root, "(down b)\n", "b/");
  root.write("a/robot_domain.pddl", "(define");
  const Ended ended = bench(root, {"--runs", "1", "--json", "--csv", root / "table.csv"});
  EXPECT_EQ(ended.status, 2);
  const json rows = ended.json();
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0]["outcome"].get<std::string>().rfind("error: ", 0), 0U) << rows[0];
  EXPECT_FALSE(rows[0].contains("questions_mean"));
  EXPECT_EQ(rows[3]["instance"], "b");
  EXPECT_TRUE(rows[3].contains("questions_mean"));
  EXPECT_TRUE(samples::isWellFormed(root.read("table_questions.svg")));
}

TEST(Bench, InstancesOfOneNameAreToldApart) {
  const Folder root;
  writeDesk(root, "(down b)\n", "x/desk/");
  writeDesk(root, "(down b)\n", "y/desk/");
  const json rows = bench(root, {"--runs", "1", "--truth", "own", "--json"}).json();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["instance"], "x/desk");
  EXPECT_EQ(rows[1]["instance"], "y/desk");
}

TEST(Bench, TakesTheOptionsOfAlign) {
  const Folder root;
  writeDesk(root, "(down b)\n(held a)\n", "desk/");
  const auto row = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--truth", "own", "--runs", "1", "--json"});
    const Ended ended = bench(root, more);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return ended.json()[0];
  };
  const json grouped = row({"--group", "6"});
  EXPECT_LE(grouped["rounds_max"], 2.0);
  EXPECT_GE(grouped["questions_mean"], 3.0);
  EXPECT_GT(row({"--negative-candidates"})["candidates"], 6);
  // Assumed to be wanted, so held a is in the way by itself: one YES.
  EXPECT_EQ(row({"--assumed-wanted", "free"})["minimum_mean"], 1.0);
  // Assumed not to be, so that conflict is hit: held b and down a are left.
  EXPECT_EQ(row({"--assumed-unwanted", "free"})["minimum_mean"], 2.0);
  EXPECT_EQ(row({"--conflicts", "lazy"})["minimum_mean"], 3.0);
}

TEST(Bench, TakesFormerNamesOfOptionsAndWarns) {
  const Folder root;
  writeDesk(root, "(down b)\n(held a)\n", "desk/");
  const Ended ended =
      bench(root, {"--hidden-not-wanted", "free", "--truth", "own", "--runs", "1", "--json"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.json()[0]["minimum_mean"], 2.0);
  EXPECT_NE(ended.err.find("--hidden-not-wanted is now called --assumed-unwanted"),
            std::string::npos)
      << ended.err;
}

// The first YES decides, but the person has looked at the whole list.
TEST(Bench, CountsAllThatAGroupShows) {
  const Folder root;
  writeDesk(root, "(down b)\n(held b)\n", "desk/");
  const json row =
      bench(root, {"--group", "6", "--truth", "own", "--runs", "1", "--json"}).json()[0];
  EXPECT_EQ(row["outcome"], "no_plan");
  EXPECT_EQ(row["rounds_max"], 1.0);
  EXPECT_EQ(row["minimum_mean"], 1.0);
  EXPECT_GT(row["questions_mean"], 1.0);
  EXPECT_NEAR(row["questions_mean"].get<double>() / 6 + row["settled_unasked"].get<double>(), 1,
              1e-9);
}

TEST(Bench, WhatTheLimitLeavesOpenHasNoMinimum) {
  const Folder root;
  writeEndless(root);
  const Ended ended =
      bench(root, {"--runs", "1", "--truth", "own", "--json", "--time-limit", "0.2"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  ASSERT_EQ(ended.json().size(), 1U);
  EXPECT_EQ(ended.json()[0]["outcome"], "undecided");
  EXPECT_FALSE(ended.json()[0].contains("minimum_mean"));
}

TEST(Bench, SummarisesAndShowsNoBarWhereThereIsNoTerminal) {
  const Folder root;
  writeDesk(root, "(down b)\n(held a)\n", "desk/");
  const Ended ended = bench(root, {"--policy", "auto", "--policy", "paper", "--runs", "2"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(ended.out.find('\r'), std::string::npos);
  EXPECT_EQ(ended.out.find('\x1b'), std::string::npos);
  EXPECT_NE(ended.out.find("of paper"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("1.000 (1)"), std::string::npos) << ended.out;
}

TEST(Bench, PlotsStandBesideTheCsv) {
  const Folder root;
  writeDesk(root, "(down b)\n(held a)\n", "a<b & c/");
  ASSERT_EQ(bench(root, {"--policy", "auto", "--policy", "paper", "--runs", "2", "--csv",
                         root / "out.csv"})
                .status,
            0);
  for (const std::string name : {"out_questions.svg", "out_time.svg"}) {
    const std::string text = root.read(name);
    EXPECT_TRUE(samples::isWellFormed(text)) << text;
    EXPECT_NE(text.find("a&lt;b &amp; c"), std::string::npos) << name;
  }
  const std::string questions = root.read("out_questions.svg");
  EXPECT_NE(questions.find("wanted with probability 0.5"), std::string::npos);
  EXPECT_NE(questions.find("clairvoyant minimum"), std::string::npos);
  EXPECT_NE(root.read("out_time.svg").find(">belief<"), std::string::npos);
}

TEST(Bench, CtrlCReportsWhatIsMeasured) {
  const Folder root;
  writeDesk(root, "(down b)\n(held a)\n", "a/");
  const Folder endless;
  samples::writeEndless(endless);
  for (const char* file : {"robot_domain.pddl", "human_domain.pddl", "robot_problem.pddl",
                           "human_problem.pddl", "human_plan.txt", "true_goal.txt"}) {
    root.write(std::string("z/") + file, endless.read(file));
  }
  for (const std::string threads : {"1", "2"}) {
    Program program({"bench", root.path(), "--runs", "1", "--json", "--threads", threads, "--csv",
                     root / "out.csv"});
    ASSERT_TRUE(program.works());
    program.signal(SIGINT);
    const Ended ended = program.wait();
    EXPECT_EQ(ended.status, 4);
    EXPECT_EQ(ended.json().size(), 3U) << ended.out;
    EXPECT_EQ(linesOf(root.read("out.csv")).size(), 4U);
  }
}

}  // namespace
}  // namespace goal_alignment::cli
