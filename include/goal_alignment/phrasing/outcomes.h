// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/phrases.h"

/// How an alignment ended, in a few sentences that nobody needs PDDL for.
namespace goal_alignment::phrasing {

/// More alternatives than this are not spoken, only counted.
constexpr std::size_t kSpokenAlternatives = 3;

/// No plan can do what was asked for: "I can't do what you asked for: …. That is certain."
std::string goalUnsolvable(const Phrases& phrases, const std::vector<Literal>& specified);

/// No plan can do all that is wanted: the reason, "That is certain.", and what there is instead.
std::string expectationUnachievable(const Phrases& phrases, const std::vector<Literal>& conflict,
                                    const std::vector<std::vector<Literal>>& alternatives);

/// What nobody is sure of would decide: the reason, and "It depends on whether this matters: …."
std::string unsureBlocks(const Phrases& phrases, const std::vector<Literal>& conflict, bool proven,
                         const std::vector<Literal>& deciding);

/// The limits ended the search: "I could not make sure that I can have …".
std::string leftOpen(const Phrases& phrases, const std::vector<Literal>& conflict);

/// There is a plan, but it does not promise this, of which nobody was asked.
std::string planWithout(const Phrases& phrases, const std::vector<Literal>& assumed_not_wanted);

/// "If it mattered that …; and that …", "If it did not matter that …", or both: what a supposition
/// begins with.
std::string supposition(const Phrases& phrases, const std::vector<Literal>& wanted,
                        const std::vector<Literal>& not_wanted);

}  // namespace goal_alignment::phrasing
