// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/pddl/source_position.h"

namespace goal_alignment::pddl {

/// What FF and its children print around a plan becomes blanks, so that the steps keep their
/// places: all before `ff: found legal plan as follows`, the word `step` before the first step's
/// number, `plan cost: …`, and `time spent:` with the lines of seconds behind it. What may be a
/// step stays wherever it stands. O(text).
Source withoutChatter(Source source);

}  // namespace goal_alignment::pddl
