// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// What stands in texts beyond ASCII: letters, which names may have, and what only looks like PDDL.
namespace goal_alignment::pddl {

/// Whether a name may have this character of UTF-8. All may but for those that a person would take
/// for PDDL's own blanks, dashes and brackets, or would not see at all.
bool passesForLetter(std::string_view character);

/// What stands at the offset, where no PDDL does: `the byte 0xe9, which is no UTF-8; …`,
/// `U+2013, a dash other than '-'`.
std::string foreignCharacter(std::string_view text, std::size_t offset);

}  // namespace goal_alignment::pddl
