// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <limits>
#include <string>
#include <vector>

#include "goal_alignment/session/options.h"

namespace goal_alignment::cli {

/// The words that choose how an alignment thinks, as the user typed them.
struct AlignmentWords {
  std::string policy = "auto";
  std::uint64_t seed = 0;
  std::string belief = "normalised";
  double beta = 1;
  double kappa = 1;
  std::string conflicts = "full";
  int group = 1;
  std::string unsure_policy = "as-yes";
  bool negative_candidates = false;
  std::vector<std::string> assumed_wanted;
  std::vector<std::string> assumed_unwanted;
  double max_extra_cost = std::numeric_limits<double>::infinity();
  bool costs = false;
  bool no_static = false;
  std::string plan = "first";
  double time_limit = 0;  ///< seconds of thinking; 0: none
  std::size_t memory_limit_mib = 2048;
  int threads = 1;

  /// Adds the options that `align` and `bench` share, but for the policy.
  void add(CLI::App& command);

  /// Throws CLI::ValidationError.
  session::Options options() const;
};

}  // namespace goal_alignment::cli
