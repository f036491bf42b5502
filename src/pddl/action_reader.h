// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/pddl/ast.h"
#include "token_reader.h"

namespace goal_alignment::pddl {

/// What follows `(:action`, up to the `)`, which it leaves.
ast::Action readAction(TokenReader& reader);

}  // namespace goal_alignment::pddl
