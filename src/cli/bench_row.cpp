// SPDX-License-Identifier: BSD-3-Clause
#include "bench_row.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace goal_alignment::cli {

namespace {

std::optional<double> excess(double mean, double least) {
  if (least > 0) return mean / least - 1;
  if (mean > 0) return std::nullopt;
  return 0;
}

}  // namespace

void Sample::add(double value) {
  ++count_;
  sum_ += value;
  const double off = value - centre_;
  centre_ += off / static_cast<double>(count_);
  squares_ += off * (value - centre_);
  most_ = count_ == 1 ? value : std::max(most_, value);
}

double Sample::deviation() const {
  return count_ < 2 ? 0 : std::sqrt(squares_ / static_cast<double>(count_ - 1));
}

void Row::add(const RunFigures& run) {
  candidates = run.candidates;
  candidates_static = run.candidates_static;
  if (run.candidates > 0)
    settled.add(static_cast<double>(run.settled) / static_cast<double>(run.candidates));
  questions.add(static_cast<double>(run.questions));
  rounds.add(static_cast<double>(run.rounds));
  first_question.add(run.first_question);
  for (const double answer_seconds : run.per_answer)
    per_answer.add(answer_seconds);
  const session::Statistics& spent = run.spent;
  seconds.add(spent.total);
  const std::array<double, kPhases.size()> split = {spent.parse,     spent.ground,    spent.belief,
                                                    spent.conflicts, spent.questions, spent.plan};
  for (std::size_t i = 0; i < split.size(); ++i)
    phases[i].add(split[i]);
  planner_calls.add(static_cast<double>(spent.planner_calls));
  ++outcomes[session::outcomeWord(run.outcome)];
}

std::optional<double> Row::gapToMinimum() const {
  if (minimum.count() == 0) return std::nullopt;
  return excess(questions.mean(), minimum.mean());
}

std::optional<double> Row::gapToOptimal() const {
  if (!of_optimal) return std::nullopt;
  return excess(questions.mean(), *of_optimal);
}

std::string Row::outcomeText() const {
  if (!error.empty()) return "error: " + error;
  std::string text;
  for (const auto& [outcome, count] : outcomes) {
    text += (text.empty() ? "" : " ") + outcome;
    if (outcomes.size() > 1) text += fmt::format(" x{}", count);
  }
  return text;
}

Json toJson(const Row& row) {
  Json json = {{"instance", row.instance}, {"policy", row.policy}, {"truth", row.truth}};
  if (row.error.empty()) {
    json["runs"] = row.questions.count();
    json["candidates"] = row.candidates;
    json["candidates_static"] = row.candidates_static;
    if (row.settled.count() > 0) json["settled_unasked"] = row.settled.mean();
    json["questions_mean"] = row.questions.mean();
    json["questions_std"] = row.questions.deviation();
    json["rounds_mean"] = row.rounds.mean();
    json["rounds_max"] = row.rounds.most();
    if (row.minimum.count() > 0) json["minimum_mean"] = row.minimum.mean();
    if (const auto gap = row.gapToMinimum()) json["gap_minimum"] = *gap;
    if (row.of_optimal) json["optimal_mean"] = *row.of_optimal;
    if (const auto gap = row.gapToOptimal()) json["gap_optimal"] = *gap;
    json["first_question_mean"] = row.first_question.mean();
    json["first_question_max"] = row.first_question.most();
    if (row.per_answer.count() > 0) {
      json["per_answer_mean"] = row.per_answer.mean();
      json["per_answer_max"] = row.per_answer.most();
    }
    json["seconds_mean"] = row.seconds.mean();
    for (std::size_t i = 0; i < kPhases.size(); ++i)
      json[std::string("seconds_") + kPhases[i]] = row.phases[i].mean();
    json["planner_calls_mean"] = row.planner_calls.mean();
  }
  json["outcome"] = row.outcomeText();
  return json;
}

}  // namespace goal_alignment::cli
