// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <utility>

#include "goal_alignment/task/task.h"
#include "oracles/state_space.h"

/// Heuristics by their textbook equations, iterated until nothing changes.
namespace goal_alignment::oracles {

/// h_max; nothing: unreachable even without deletes.
std::optional<task::Cost> hMax(const task::Task& task, const Facts& state,
                               const task::FactSet& goal);

/// {f, g} with f ≤ g; {f, f} stands for the single fact.
using Pair = std::pair<task::FactId, task::FactId>;

/// The pairs to which h² gives a finite value from the initial state.
std::set<Pair> possiblePairs(const task::Task& task);

/// The pairs that are true together in some reachable state.
std::set<Pair> reachablePairs(const task::Task& task);

}  // namespace goal_alignment::oracles
