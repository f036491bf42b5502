// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "analysis.h"
#include "dialogue.h"

/// What is asked, why, and how much more may follow.
namespace goal_alignment::session {

/// Why this conflict, an index of what the robot knows, makes an answer matter; nothing: no reason.
Reason reasonFor(const Analysis& analysis, std::optional<std::size_t> conflict);

/// Whether it is proven that its one fluent can't be had, whatever else is asked for.
bool isUnachievableAlone(const Analysis& analysis, const achievability::Conflict& conflict);

/// What the open question looks like, with what is known now.
QuestionView openQuestion(const Dialogue& dialogue, const Analysis& analysis,
                          const Options& options);

/// Whether the open question can still change the outcome, after what was volunteered.
bool stillMatters(const QuestionView& question, const Dialogue& dialogue, const Analysis& analysis);

/// How many candidates a question may still be about. Each question is about one at least.
std::size_t maxRemaining(const Analysis& analysis, const questions::Situation& now,
                         const Options& options);

}  // namespace goal_alignment::session
