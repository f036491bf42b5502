// SPDX-License-Identifier: BSD-3-Clause
#include "bench_report.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::cli {

namespace {

std::string percent(const std::optional<double>& share) {
  return share ? fmt::format("{:+.1f} %", 100 * *share) : "-";
}

/// The distinct values in order of their first occurrence.
std::vector<std::pair<std::string, std::string>> truthsAndPolicies(const std::vector<Row>& rows) {
  std::vector<std::pair<std::string, std::string>> keys;
  std::set<std::pair<std::string, std::string>> seen;
  for (const Row& row : rows)
    if (seen.insert({row.truth, row.policy}).second) keys.emplace_back(row.truth, row.policy);
  return keys;
}

std::string summaryLine(const std::string& truth, const std::string& policy,
                        const std::vector<Row>& rows) {
  Sample questions;
  Sample settled;
  Sample rounds;
  Sample above;
  Sample to_optimal;
  Sample first;
  Sample answer;
  for (const Row& row : rows) {
    if (row.truth != truth || row.policy != policy || !row.error.empty()) continue;
    questions.add(row.questions.mean());
    rounds.add(row.rounds.most());
    first.add(row.first_question.most());
    answer.add(row.per_answer.most());
    if (row.settled.count() > 0) settled.add(row.settled.mean());
    if (const auto gap = row.gapToMinimum()) above.add(*gap);
    if (const auto gap = row.gapToOptimal()) to_optimal.add(*gap);
  }
  const auto gap = [](const Sample& sample) {
    return percent(sample.count() > 0 ? std::optional(sample.mean()) : std::nullopt);
  };
  const PaperRatio ratio = ratioToPaper(rows, policy, truth);
  const std::string of_paper =
      ratio.instances > 0 ? fmt::format("{:.3f} ({})", ratio.geometric_mean, ratio.instances) : "-";
  return fmt::format(
      "{:<6} {:<8} {:>9} {:>10.2f} {:>12} {:>8.1f} % {:>10} {:>11} {:>7.0f} {:>9.3f} s {:>7.3f} "
      "s\n",
      truth, policy, questions.count(), questions.mean(), of_paper, 100 * settled.mean(),
      gap(above), gap(to_optimal), rounds.most(), first.most(), answer.most());
}

/// A field as RFC 4180 has it.
std::string cell(const Json& value) {
  if (!value.is_string()) return value.dump();
  std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

/// Every field a row can have, in its order.
std::vector<std::string> columns() {
  Row all;
  RunFigures run;
  run.candidates = 1;
  run.per_answer = {0};
  all.add(run);
  all.minimum.add(0);
  all.of_optimal = 0;
  std::vector<std::string> names;
  const Json fields = toJson(all);
  for (const auto& [name, value] : fields.items())
    names.push_back(name);
  return names;
}

}  // namespace

BenchTable::BenchTable(std::ostream& out, std::size_t widest)
    : out_(out), width_(std::max<std::size_t>(widest, 8)) {}

void BenchTable::print(const std::vector<Row>& rows) {
  if (!std::exchange(begun_, true)) {
    out_ << fmt::format(
        "{:<{}} {:<6} {:<8} {:>9} {:>13} {:>6} {:>8} {:>6} {:>9} {:>11} {:>10} {:>9}  outcome\n",
        "instance", width_, "truth", "policy", "cand./dyn", "questions", "rounds", "unasked",
        "least", "above", "to optimal", "first", "answer");
  }
  for (const Row& row : rows) {
    out_ << fmt::format("{:<{}} {:<6} {:<8} ", row.instance, width_, row.truth, row.policy);
    if (row.error.empty()) {
      const std::string least =
          row.minimum.count() > 0 ? fmt::format("{:.1f}", row.minimum.mean()) : "-";
      out_ << fmt::format(
          "{:>4}/{:<4} {:>5.1f} ± {:<5.1f} {:>6.1f} {:>6.0f} % {:>6} {:>9} {:>11} {:>8.3f} s "
          "{:>7.3f} s  ",
          row.candidates, row.candidates - row.candidates_static, row.questions.mean(),
          row.questions.deviation(), row.rounds.mean(), 100 * row.settled.mean(), least,
          percent(row.gapToMinimum()), percent(row.gapToOptimal()), row.first_question.mean(),
          row.per_answer.mean());
    }
    out_ << row.outcomeText() << '\n';
  }
  out_ << std::flush;
}

void BenchTable::printSummary(const std::vector<Row>& rows) {
  if (std::all_of(rows.begin(), rows.end(), [](const Row& row) { return !row.error.empty(); }))
    return;
  out_ << fmt::format("\n{:<6} {:<8} {:>9} {:>10} {:>12} {:>10} {:>10} {:>11} {:>7} {:>11} {:>9}\n",
                      "truth", "policy", "instances", "questions", "of paper", "unasked", "above",
                      "to optimal", "rounds", "first", "answer");
  for (const auto& [truth, policy] : truthsAndPolicies(rows))
    out_ << summaryLine(truth, policy, rows);
  out_ << "\nQuestions, unasked and gaps are means over the instances; above: the least that a "
          "clairvoyant needs;\nof paper: the geometric mean over those (so many) where both ask; "
          "rounds and times are the largest.\n"
       << std::flush;
}

PaperRatio ratioToPaper(const std::vector<Row>& rows, const std::string& policy,
                        const std::string& truth) {
  PaperRatio ratio;
  double logarithms = 0;
  for (const Row& own : rows) {
    if (own.policy != policy || own.truth != truth) continue;
    const auto paper = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
      return row.instance == own.instance && row.truth == truth && row.policy == "paper";
    });
    if (paper == rows.end() || own.questions.mean() <= 0 || paper->questions.mean() <= 0) continue;
    logarithms += std::log(own.questions.mean() / paper->questions.mean());
    ++ratio.instances;
  }
  if (ratio.instances > 0)
    ratio.geometric_mean = std::exp(logarithms / static_cast<double>(ratio.instances));
  return ratio;
}

void writeCsv(const std::vector<Row>& rows, const std::string& file) {
  std::ofstream out(file);
  const std::vector<std::string> names = columns();
  for (const std::string& name : names)
    out << (name == names.front() ? "" : ",") << name;
  out << '\n';
  for (const Row& row : rows) {
    const Json fields = toJson(row);
    for (const std::string& name : names)
      out << (name == names.front() ? "" : ",")
          << (fields.contains(name) ? cell(fields[name]) : "");
    out << '\n';
  }
  if (!out.flush()) throw pddl::InputError(file, {}, "can't write here");
}

}  // namespace goal_alignment::cli
