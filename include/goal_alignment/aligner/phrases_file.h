// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "goal_alignment/phrasing/phrases.h"

namespace goal_alignment::aligner {

/// The templates of the file; none for "". Throws std::runtime_error.
phrasing::Phrases phrasesOf(const std::string& file);

}  // namespace goal_alignment::aligner
