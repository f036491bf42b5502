// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bar_chart.h"
#include "bench_report.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::cli {

namespace {

using Names = std::vector<std::string>;

/// The values of a field, in order of their first occurrence in the rows that ran.
Names valuesOf(const std::vector<Row>& rows, std::string Row::*field) {
  Names names;
  for (const Row& row : rows) {
    if (row.error.empty() && std::find(names.begin(), names.end(), row.*field) == names.end())
      names.push_back(row.*field);
  }
  return names;
}

std::size_t indexOf(const std::string& name, const Names& names) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::string title(const std::string& truth) {
  return truth == "own" ? "the instances' own truth"
                        : "each candidate wanted with probability " + truth;
}

BarChart questionsChart(const std::vector<Row>& rows) {
  const Names policies = valuesOf(rows, &Row::policy);
  BarChart chart = {"Questions by policy, mean and standard deviation",
                    "questions",
                    policies,
                    "clairvoyant minimum",
                    {}};
  for (const std::string& truth : valuesOf(rows, &Row::truth)) {
    BarPanel panel = {title(truth), {}};
    for (const Row& row : rows) {
      if (row.truth != truth || !row.error.empty()) continue;
      if (panel.groups.empty() || panel.groups.back().label != row.instance)
        panel.groups.push_back({row.instance, {}, std::nullopt});
      BarGroup& group = panel.groups.back();
      group.bars.push_back(
          {{row.questions.mean()}, indexOf(row.policy, policies), row.questions.deviation()});
      if (row.minimum.count() > 0) group.mark = row.minimum.mean();
    }
    chart.panels.push_back(std::move(panel));
  }
  return chart;
}

/// The time depends little on what is wanted, so a bar is the mean over the truths.
BarChart timeChart(const std::vector<Row>& rows) {
  BarChart chart = {"Where the time of one alignment goes, mean",
                    "seconds",
                    {kPhases.begin(), kPhases.end()},
                    "",
                    {}};
  for (const std::string& policy : valuesOf(rows, &Row::policy)) {
    BarPanel panel = {"policy " + policy, {}};
    for (const std::string& instance : valuesOf(rows, &Row::instance)) {
      std::vector<Sample> phases(kPhases.size());
      for (const Row& row : rows) {
        if (row.policy != policy || row.instance != instance || !row.error.empty()) continue;
        for (std::size_t i = 0; i < phases.size(); ++i)
          phases[i].add(row.phases[i].mean());
      }
      Bar bar;
      for (const Sample& phase : phases)
        bar.parts.push_back(phase.mean());
      panel.groups.push_back({instance, {bar}, std::nullopt});
    }
    chart.panels.push_back(std::move(panel));
  }
  return chart;
}

void write(const BarChart& chart, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << svg(chart);
  if (!out.flush()) throw pddl::InputError(file.string(), {}, "can't write here");
}

}  // namespace

void writePlots(const std::vector<Row>& rows, const std::string& csv_file) {
  const std::filesystem::path file(csv_file);
  const auto beside = [&](const char* ending) {
    return file.parent_path() / (file.stem().string() + ending);
  };
  write(questionsChart(rows), beside("_questions.svg"));
  write(timeChart(rows), beside("_time.svg"));
}

}  // namespace goal_alignment::cli
