// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// How many more candidates a person would rather look at than be asked once more: a line to read
/// takes a second or two, an interruption several times that.
inline constexpr double kLinesPerRound = 5;

/// One more line costs 1 where the outcome was decided without it, and nothing where it was not,
/// for it would be shown in the next round; at best it saves a round wherever the outcome was not
/// decided. So it pays as long as P(undecided) · kLinesPerRound > 1 − P(undecided).
inline constexpr double kWorthALine = 1 / (1 + kLinesPerRound);

/// What one question "which of these matter to you?" offers: `most` candidates at most (1: what
/// `policy` asks next), each once and with its own reason; what the person does not name does not
/// matter to them. Empty: nothing is left to ask. Meant to end the dialogue in few rounds without
/// showing many candidates.
///
/// Adds what the policy would ask at the likeliest combination of answers to the group that leaves
/// the outcome open, as long as P(undecided) is above kWorthALine. Policies without conflicts offer
/// what comes next in their order. Calls policy.next() `most` times at most.
std::vector<Choice> nextGroup(Policy& policy, const Situation& situation, std::size_t most);

}  // namespace goal_alignment::questions
