// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "bench_row.h"
#include "goal_alignment/cli/alignment_options.h"

namespace goal_alignment::cli {

/// What is measured on every instance.
struct BenchPlan {
  std::vector<Truth> truths;
  std::vector<std::string> policies;
  int runs = 10;
  AlignmentWords words;

  /// The policies that run: `optimal` is what the others are compared with.
  std::vector<std::string> running() const;
  /// The alignments of one instance under one truth.
  std::size_t runsOfTruth() const;
};

struct InstanceFolder {
  std::string path;
  std::string name;  ///< the folder's; with those above it where that would be ambiguous
};

/// Those at and below the folder, by path. Throws pddl::InputError where there are none.
std::vector<InstanceFolder> instancesBelow(const std::string& root);

struct InstanceResult {
  std::vector<Row> rows;  ///< by truth, then by policy as the user named them
  std::string note;       ///< what is missing, if anything
};

/// Measures the plan's policies under its truths. Every run is an alignment of its own, from the
/// models' texts on, so that its times are true. Once `sessions` are cancelled it returns the rows
/// that are complete. `count(n)` is called after n alignments, done or given up.
InstanceResult measureInstance(const InstanceFolder& instance, const BenchPlan& plan,
                               RunningSessions& sessions,
                               const std::function<void(std::size_t)>& count);

}  // namespace goal_alignment::cli
