// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "cli/bar_chart.h"
#include "cli/bench_report.h"
#include "cli/bench_truth.h"
#include "cli/progress_bar.h"
#include "program.h"
#include "unit/cli/xml.h"

/// What `hagl bench` is made of.
namespace goal_alignment::cli {
namespace {

using samples::Folder;
using samples::isWellFormed;

Literal fluent(int i) {
  return {{"f", {"o" + std::to_string(i)}}, false};
}

TEST(Truths, AreOwnAndTwoDrawnOnesUnlessNamed) {
  const std::vector<Truth> all = truthsNamed({});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_FALSE(all[0].wanted.has_value());
  EXPECT_EQ(all[1].wanted, 0.2);
  EXPECT_EQ(all[2].wanted, 0.5);
  EXPECT_EQ(truthsNamed({"0.3", "0.3"}).size(), 1U);
  for (const std::string wrong : {"p", "-0.1", "1.1", "nan", ""})
    EXPECT_THROW(truthsNamed({wrong}), CLI::ValidationError) << wrong;
}

TEST(Truths, AreDrawnFromTheSeedAndTheInstance) {
  constexpr int kMany = 4000;
  int rare = 0;
  int often = 0;
  int other_seed = 0;
  int other_instance = 0;
  for (int i = 0; i < kMany; ++i) {
    const bool wanted = drawnTruth(0.5, "desk", 7)(fluent(i));
    EXPECT_EQ(drawnTruth(0.5, "desk", 7)(fluent(i)), wanted);
    const bool wanted_rarely = drawnTruth(0.2, "desk", 7)(fluent(i));
    EXPECT_LE(wanted_rarely, wanted);
    rare += wanted_rarely ? 1 : 0;
    often += wanted ? 1 : 0;
    other_seed += drawnTruth(0.5, "desk", 8)(fluent(i)) == wanted ? 1 : 0;
    other_instance += drawnTruth(0.5, "tea", 7)(fluent(i)) == wanted ? 1 : 0;
  }
  EXPECT_NEAR(rare, 0.2 * kMany, 120);
  EXPECT_NEAR(often, 0.5 * kMany, 150);
  EXPECT_NEAR(other_seed, 0.5 * kMany, 150);
  EXPECT_NEAR(other_instance, 0.5 * kMany, 150);
  EXPECT_FALSE(drawnTruth(0, "desk", 7)(fluent(0)));
  EXPECT_TRUE(drawnTruth(1, "desk", 7)(fluent(0)));
}

TEST(Samples, HaveMeanDeviationAndMaximum) {
  Sample sample;
  EXPECT_EQ(sample.mean(), 0);
  EXPECT_EQ(sample.deviation(), 0);
  for (const double value : {2.0, 4.0, 9.0})
    sample.add(value);
  EXPECT_DOUBLE_EQ(sample.mean(), 5);
  EXPECT_DOUBLE_EQ(sample.deviation(), std::sqrt(13));
  EXPECT_EQ(sample.most(), 9);
}

Row rowOf(const std::string& instance, const std::string& policy, double questions) {
  Row row;
  row.instance = instance;
  row.policy = policy;
  row.truth = "own";
  row.questions.add(questions);
  return row;
}

TEST(Rows, HaveNoGapWhereItIsNotDefined) {
  Row row = rowOf("a", "auto", 3);
  EXPECT_FALSE(row.gapToMinimum());
  row.minimum.add(0);
  EXPECT_FALSE(row.gapToMinimum());  // any share of nothing
  row.minimum.add(4);
  EXPECT_DOUBLE_EQ(*row.gapToMinimum(), 0.5);
  EXPECT_FALSE(row.gapToOptimal());
  row.of_optimal = 2;
  EXPECT_DOUBLE_EQ(*row.gapToOptimal(), 0.5);
  Row none = rowOf("a", "auto", 0);
  none.minimum.add(0);
  EXPECT_EQ(none.gapToMinimum(), 0);
}

TEST(Report, ComparesWithPaperWhereBothAsk) {
  const std::vector<Row> rows = {
      rowOf("a", "auto", 1), rowOf("a", "paper", 4), rowOf("b", "auto", 1), rowOf("b", "paper", 1),
      rowOf("c", "auto", 0), rowOf("c", "paper", 5), rowOf("d", "auto", 2)};
  const PaperRatio ratio = ratioToPaper(rows, "auto", "own");
  EXPECT_EQ(ratio.instances, 2U);
  EXPECT_DOUBLE_EQ(ratio.geometric_mean, 0.5);
  EXPECT_EQ(ratioToPaper(rows, "auto", "0.5").instances, 0U);
}

TEST(Report, QuotesWhatACsvMustQuote) {
  const Folder folder;
  Row row = rowOf("a,b", "auto", 1);
  row.error = "found \"x\"";
  writeCsv({row}, folder / "t.csv");
  const std::string text = folder.read("t.csv");
  EXPECT_NE(text.find("\n\"a,b\",auto,own,,"), std::string::npos) << text;
  EXPECT_NE(text.find(",\"error: found \"\"x\"\"\"\n"), std::string::npos) << text;
}

TEST(BarCharts, AreWellFormedWhateverTheyShow) {
  EXPECT_TRUE(isWellFormed(svg(BarChart{"empty", "y", {}, "", {}})));
  BarChart chart = {"a < b & c", "n", {"one", "two"}, "least", {{"first", {}}}};
  EXPECT_TRUE(isWellFormed(svg(chart)));
  chart.panels[0].groups = {{"x", {{{0}, 0, 0}, {{3, 2}, 0, 1}}, 2.0}, {"y", {}, std::nullopt}};
  EXPECT_TRUE(isWellFormed(svg(chart)));
}

TEST(BarCharts, BarsAreAsHighAsTheirValues) {
  BarChart chart = {"t", "n", {"one"}, "", {{"p", {{"x", {{{10}, 0, 0}}, std::nullopt}}}}};
  const std::string text = svg(chart);
  EXPECT_NE(text.find("height=\"180.00\" fill=\"#0072b2\""), std::string::npos) << text;
  chart.panels[0].groups[0].bars.push_back({{5}, 1, 0});
  EXPECT_NE(svg(chart).find("height=\"90.00\" fill=\"#d55e00\""), std::string::npos);
}

TEST(ProgressBars, AreErasedAndSilentWithoutATerminal) {
  std::ostringstream out;
  {
    ProgressBar bar(&out, 4);
    bar.draw(1);
    EXPECT_NE(out.str().find("1 of 4 alignments"), std::string::npos) << out.str();
    bar.draw(9);
    EXPECT_NE(out.str().find("4 of 4"), std::string::npos) << out.str();
  }
  const std::string text = out.str();
  EXPECT_EQ(text.substr(text.size() - 4), "\r\x1b[K");
  ProgressBar none(nullptr, 4);
  none.draw(1);
  none.erase();
  EXPECT_EQ(progressStream(false), nullptr);
}

}  // namespace
}  // namespace goal_alignment::cli
