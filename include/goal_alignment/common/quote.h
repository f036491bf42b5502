// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace goal_alignment {

/// Bytes of the character at the front of a text that is not empty, or 0 where none is (The Unicode
/// Standard, table 3-7).
std::size_t utf8CharacterLength(std::string_view text);

/// How many bytes from the front, at most `most`, are whole characters of well-formed UTF-8.
/// O(most).
std::size_t utf8Length(std::string_view text, std::size_t most);

/// Text from outside as a message may hold it: cut short with `…` after `most` bytes, and where it
/// stops being UTF-8.
std::string shortened(std::string_view text, std::size_t most = 300);

/// Text from outside in quotes, for a message: shortened with `…` where no person would read it to
/// its end, and where it stops being UTF-8, which messages must be.
std::string inQuotes(std::string_view text);

}  // namespace goal_alignment
