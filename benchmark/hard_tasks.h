// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/session/session.h"

/// Alignments that stay in one phase for long.
namespace goal_alignment::benchmarks {

/// Many megabytes of facts: reading.
session::Input longText(int facts);

/// One action over all five-tuples of objects, all of them reachable: grounding.
session::Input wideAction(int objects);

/// One ring more than the robot has pegs, of which the person knows nothing: a conflict that only
/// counting proves, so the analysis searches on and on.
session::Input tooFewPegs(int pegs);

/// A tower to be turned over by models that agree: nothing to ask, but a long way to the optimal
/// plan.
session::Input turnedTower(int blocks);

}  // namespace goal_alignment::benchmarks
