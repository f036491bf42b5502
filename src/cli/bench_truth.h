// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::cli {

/// One of the truths that an instance is measured under.
struct Truth {
  std::string name;              ///< `own`, `0.2`, …
  std::optional<double> wanted;  ///< each candidate with this probability; else true_goal.txt
};

/// Own, 0.2 and 0.5 where there are no names. Throws CLI::ValidationError.
std::vector<Truth> truthsNamed(const std::vector<std::string>& names);

/// Whether the person wants this candidate.
using Wants = std::function<bool(const Literal&)>;

/// A truth drawn from the seed: each candidate is wanted with this probability, whatever becomes of
/// the others. It depends on nothing else, so policies and options are compared under the same
/// truths; and what is wanted with a low probability is wanted with a higher one, too.
Wants drawnTruth(double probability, const std::string& instance, std::uint64_t seed);

}  // namespace goal_alignment::cli
