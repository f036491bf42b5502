// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/session/outcome.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::ros_interface {

/// What people are told of an outcome: in words where fluents are named, else the session's own
/// message. `last` is how things stood then.
std::string spokenOutcome(const session::Outcome& outcome, const session::Snapshot& last,
                          const phrasing::Phrases& phrases);

}  // namespace goal_alignment::ros_interface
