// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "token_reader.h"

namespace goal_alignment::pddl {

/// At a keyword of PDDL's later versions, its earliest or its dialects, be it of a section or of an
/// action: throws UnsupportedError.
void refuseForeign(const TokenReader& reader);

}  // namespace goal_alignment::pddl
