// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

/// How many lines a person would rather read than be interrupted once more: a line takes a second
/// or two, an interruption several times that.
inline constexpr double kLinesPerRound = 5;

/// Up to which P(the outcome is undecided) one more line pays. It costs 1 where the outcome was
/// decided without it, and nothing where it was not, since it would be shown in the next round;
/// there it saves a round at best. So it pays as long as P(undecided) · kLinesPerRound > 1 −
/// P(undecided).
inline constexpr double kMinUndecided = 1 / (1 + kLinesPerRound);

/// What one question "which of these matter to you?" offers: at most `max_candidates` candidates
/// (1: what `policy` asks next), each once and with its own reason; what the person does not name
/// does not matter to them. Empty where nothing is left to ask. Meant to end the dialogue in few
/// rounds without showing many candidates.
///
/// Adds what the policy would ask at the likeliest combination of answers to the group that leaves
/// the outcome open, as long as P(undecided) is above kMinUndecided. Policies without conflicts
/// offer what comes next in their order. Calls policy.next() at most `max_candidates` times.
std::vector<Choice> nextGroup(Policy& policy, const Situation& situation,
                              std::size_t max_candidates);

}  // namespace goal_alignment::questions
