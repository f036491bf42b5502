// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "analysis.h"
#include "dialogue.h"

/// What onlookers see of a session.
namespace goal_alignment::session {

/// How far a session is.
struct Stage {
  State state = State::Idle;
  float progress = 0;        ///< 0 … 1
  bool is_deciding = false;  ///< in Analysing: all that comes before questions is done
};

/// `question`: the open one. O(candidates · conflicts).
Snapshot snapshotOf(const Stage& stage, const Dialogue& dialogue, const Analysis& analysis,
                    const std::optional<QuestionView>& question);

}  // namespace goal_alignment::session
