// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/questions/policy.h"

/// Conflicts without a task behind them, to measure policies on.
namespace goal_alignment::benchmarks {

/// `pairs` and `triples`: random ones, as many as asked for. `stars`: a few candidates, each in
/// conflict with many others. `disjoint`: of one to four candidates each. `chain`: each candidate
/// with the next. `cliques`: of a few candidates only one can be had.
std::vector<std::string> conflictFamilies();

/// Nothing is answered yet. Each candidate is wanted with a chance drawn evenly from [least, most].
/// `conflicts` counts for pairs and triples alone, and there must be as many different ones. Throws
/// std::invalid_argument for an unknown family.
questions::Situation conflictFamily(const std::string& family, std::size_t candidates,
                                    std::size_t conflicts, double least, double most,
                                    RandomSource& random);

/// How many questions the policy is expected to ask, exactly, with independent answers. O(2^n)
/// calls where it may ask n.
double expectedQuestions(questions::Policy& policy, const questions::Situation& situation);

}  // namespace goal_alignment::benchmarks
