// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/achievability/candidate_set.h"
#include "goal_alignment/alignment/problem.h"

/// Candidates as fluents, and fluents as text.
namespace goal_alignment::session {

std::vector<Literal> fluentsOf(const alignment::Problem& problem,
                               const achievability::CandidateSet& candidates);

/// The literals of the specified goal, and then these candidates.
std::vector<Literal> specifiedAnd(const alignment::Problem& problem,
                                  const achievability::CandidateSet& candidates);

/// As the models' writers spelled the names; the robot's model comes first.
std::string spelling(const alignment::Problem& problem, const GroundName& ground);

/// In the models' spelling, with commas.
std::string listed(const alignment::Problem& problem, const std::vector<Literal>& literals);

/// The specified goal as text, its condition included.
std::string askedFor(const alignment::Problem& problem);

/// The parameter names of the action's schema in the robot's model; empty where it has none.
std::vector<std::string> parameterNames(const alignment::Problem& problem,
                                        const std::string& action);

}  // namespace goal_alignment::session
