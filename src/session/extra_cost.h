// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "analysis.h"
#include "dialogue.h"

/// A plan keeps everything that was not answered NO, and that can make a robot do visible nonsense
/// for things nobody cares about. Here is what keeping them costs. All of it throws LimitReached on
/// a cancel; any other limit leaves the plan as cheap as it was found.
namespace goal_alignment::session {

/// Whether something may have to be asked about for its cost alone.
bool costsMatter(const Options& options);

/// `plan` has more than `set`: one for the set alone, cheaper as far as a short search finds it.
/// For what is only told and decides nothing.
search::Improved improveBriefly(Analysis& analysis, const achievability::CandidateSet& set,
                                const task::Plan& plan);

/// The candidates that hold after the plan.
achievability::CandidateSet trueAtEnd(const Analysis& analysis, const task::Plan& plan);

/// Those of `open` that each cost more than `max_extra_cost` to have besides `kept`, `max_count` at
/// most, the least likely first. The plan has all of both. A search for `kept`, and one for each of
/// `open`.
std::vector<Dialogue::AskedCandidate> tooCostly(Analysis& analysis,
                                                const achievability::CandidateSet& kept,
                                                const achievability::CandidateSet& open,
                                                const task::Plan& plan, double max_extra_cost,
                                                std::size_t max_count);

}  // namespace goal_alignment::session
