// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace goal_alignment::phrasing {

/// What of a text counts where words are compared: Latin letters become lower case without accents,
/// however those are encoded, `ß` becomes `ss`, `æ` becomes `ae`. Everything else stays as it is,
/// what is no UTF-8 included. O(text).
std::string folded(std::string_view text);

}  // namespace goal_alignment::phrasing
