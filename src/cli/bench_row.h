// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "bench_run.h"
#include "goal_alignment/cli/json_output.h"

namespace goal_alignment::cli {

/// Figures of which the mean and the spread count.
class Sample {
 public:
  void add(double value);
  std::size_t count() const { return count_; }
  double mean() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }
  double most() const { return most_; }
  /// Of the sample, as the papers' tables have it.
  double deviation() const;

 private:
  std::size_t count_ = 0;
  double sum_ = 0;
  double centre_ = 0;  // Welford's running mean, and the sum of squares around it
  double squares_ = 0;
  double most_ = 0;
};

/// The phases of session::Statistics, in their order.
inline constexpr std::array<const char*, 6> kPhases = {"parse",     "ground",    "belief",
                                                       "conflicts", "questions", "plan"};

/// What the runs of one policy on one instance under one truth came to.
struct Row {
  std::string instance;
  std::string policy;
  std::string truth;
  std::string error;  ///< why there are no runs
  std::size_t candidates = 0;
  std::size_t candidates_static = 0;
  Sample settled;  ///< share of the candidates, in each run with any
  Sample questions;
  Sample rounds;
  Sample minimum;  ///< without a value where not all conflicts are known
  Sample first_question;
  Sample per_answer;
  Sample seconds;
  std::array<Sample, kPhases.size()> phases;
  Sample planner_calls;
  std::map<std::string, int> outcomes;
  std::optional<double> of_optimal;  ///< the policy `optimal`'s mean questions, same truths

  void add(const RunFigures& run);
  /// By what share the questions exceed the least; nothing where that is 0 and they are not, or
  /// where it is not known.
  std::optional<double> gapToMinimum() const;
  std::optional<double> gapToOptimal() const;
  /// `plan_found`, `no_plan x3 plan_found x7`, `error: …`.
  std::string outcomeText() const;
};

/// The fields of `hagl bench --json` and the columns of its CSV, in their order. One that does not
/// apply is absent.
Json toJson(const Row& row);

}  // namespace goal_alignment::cli
