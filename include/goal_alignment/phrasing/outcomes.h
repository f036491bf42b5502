// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/phrases.h"

/// How an alignment ended, in a few sentences that nobody needs PDDL for.
namespace goal_alignment::phrasing {

/// More alternatives than this are not spoken, only counted.
constexpr std::size_t kSpokenAlternatives = 3;

/// What ended a search.
enum class Limit : std::uint8_t { Time, Memory, Budget };

/// No plan can do what was asked for: "I can't do what you asked for: …. That is certain."
std::string goalUnsolvable(const Phrases& phrases, const std::vector<Literal>& specified);

/// "I can do everything except: …. Or everything except: …. There are 2 more ways."
std::string insteadOf(const Phrases& phrases,
                      const std::vector<std::vector<Literal>>& alternatives);

/// No plan can do all that is wanted: the reason, "That is certain.", and what there is instead.
std::string expectationUnachievable(const Phrases& phrases, const questions::Reason& reason,
                                    const std::vector<std::vector<Literal>>& alternatives);

/// What nobody is sure of would decide: the reason, "It depends on whether this matters: ….", and
/// what there is instead.
std::string unsureBlocks(const Phrases& phrases, const questions::Reason& reason,
                         const std::vector<Literal>& deciding,
                         const std::vector<std::vector<Literal>>& alternatives);

/// The limit ended the search: "I could not find out whether I can have …".
std::string leftOpen(const Phrases& phrases, const std::vector<Literal>& conflict, Limit limit);
/// The same before there was a conflict to name; `where` the program was, in English.
std::string leftOpen(const Phrases& phrases, const std::string& where, Limit limit);

/// There is a plan; what nobody was asked about it may not promise.
std::string planFound(const Phrases& phrases, const std::vector<Literal>& not_promised);

/// The person's plan, if there is one, does not lead to what was asked for.
std::string planMisses(const Phrases& phrases, const std::vector<Literal>& missing, bool has_plan);

/// "If it mattered that …, and that …", "If it did not matter that …", or both: what a supposition
/// begins with. Nothing supposed: "As things stand".
std::string supposition(const Phrases& phrases, const std::vector<Literal>& wanted,
                        const std::vector<Literal>& not_wanted);

}  // namespace goal_alignment::phrasing
