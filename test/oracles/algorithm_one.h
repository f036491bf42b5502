// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "oracles/random_hagl.h"

/// goal-alignment.tex, Algorithm 1, line by line, with brute force in place of the planner.
namespace goal_alignment::oracles {

struct AlgorithmOneRun {
  std::vector<std::size_t> questions;  ///< candidates in the order asked
  bool plan_found = false;             ///< false: "No plan exists"
};

/// `queue`: all candidates, the first to be asked first.
AlgorithmOneRun algorithmOne(const Hagl& hagl, std::vector<std::size_t> queue);

/// V^Q of section 4 for every candidate, from its printed formulas.
std::vector<double> valueOfQuery(const std::vector<double>& belief,
                                 const std::vector<bool>& unachievable_alone);

/// p(f ∈ G*) ∝ exp(−β·Δ), summing to one.
std::vector<double> normalisedBeliefs(const std::vector<double>& differences, double beta);

}  // namespace goal_alignment::oracles
