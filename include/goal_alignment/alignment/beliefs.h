// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "goal_alignment/alignment/problem.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::alignment {

/// How C(π^H) − C(π̂*_f) becomes a probability: three readings of the proportionality that
/// goal-alignment.tex, section 4, leaves open.
enum class BeliefMode : std::uint8_t {
  Normalised,  ///< κ·exp(−βΔ_f) / Σ_g exp(−βΔ_g) over the non-static candidates
  Raw,         ///< exp(−βΔ_f)
  Flat,        ///< one probability for all
};

struct BeliefOptions {
  BeliefMode mode = BeliefMode::Normalised;
  double beta = 1;    ///< rationality of the human, ≥ 0
  double kappa = 1;   ///< how many goals are expected to be missing, > 0
  double flat = 0.5;  ///< the probability of BeliefMode::Flat, in [0, 1]
};

/// |C(π^H) − C(π̂*_f)| for every candidate, and how many planner calls it took.
struct CostDifferences {
  std::vector<double> values;
  std::size_t planner_calls = 0;
  bool exact = true;  ///< false: for some the upper bound stands in for what a limit left open
};

/// How the costs are to be found.
struct CostOptions {
  bool unit_costs = true;               ///< every action costs 1
  std::uint64_t states_per_search = 0;  ///< generated, in each single search
  bool bounds_may_do = false;  ///< where the model is so large that searches would take long
  int threads = 1;             ///< the result does not depend on it
  double search_seconds = std::numeric_limits<double>::infinity();  ///< for all searches together
};

/// C(π̂*_f), the optimal cost of G^H ∪ {f} in the human model, for all candidates together: by A*
/// with LM-cut where the bounds leave it open. G^H alone bounds all costs from below, prefixes of
/// π^H and of the plans found bound them from above. Candidates that never change share one search.
/// Throws LimitReached on a cancel or at the deadline while grounding.
CostDifferences costDifferences(const Problem& problem, const CostOptions& options,
                                const Limits& limits);

/// p(f ∈ G*) for every candidate, clamped to [0.02, 0.98]: exp(0) = 1 would make a fluent certain.
std::vector<double> beliefs(const Problem& problem, const std::vector<double>& differences,
                            const BeliefOptions& options);

/// p(f ∈ G*) as policy `paper` has it: normalised over all of S^H \ G^H, κ = 1, not clamped.
std::vector<double> paperBeliefs(const std::vector<double>& differences, double beta);

}  // namespace goal_alignment::alignment
