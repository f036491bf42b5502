// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis.h"
#include "dialogue.h"

/// The heart of a session: from what is known to a question or an outcome. A dialogue may end
/// exactly when the fluents answered NO hit every conflict (then everything else has a plan), or a
/// proven conflict lies within the fluents answered YES.
namespace goal_alignment::session {

struct Ask {
  std::vector<Dialogue::AskedCandidate> posed;
};

/// The plan has all of `achieved`.
struct PlanFor {
  achievability::CandidateSet achieved;
  task::Plan plan;
};

/// What was asked for can't be had by itself, proven.
struct GoalUnsolvable {
  achievability::Conflict conflict;
};

/// A proven conflict lies within what is wanted.
struct NoPlan {
  achievability::CandidateSet conflict;
};

/// No plan will be found, as long as nobody knows whether they want what is `unsure`.
struct Blocked {
  std::optional<achievability::Conflict> conflict;  ///< nothing: none with any of `unsure` is known
  achievability::CandidateSet unsure;
  bool at_once = false;  ///< under UnsurePolicy::Abort: more questions would have been left
};

/// The limits left open what the outcome depends on.
struct Exhausted {
  LimitReason limit = LimitReason::None;
  std::string message;
  std::optional<achievability::Conflict> conflict;  ///< what may not be had together
};

/// Under UnsurePolicy::Defer: these are to be asked about once more.
struct Reopen {
  achievability::CandidateSet candidates;
  bool then_ask = false;  ///< nextQuestion() is what follows; else decide() anew
};

using Decision = std::variant<Ask, PlanFor, GoalUnsolvable, NoPlan, Blocked, Exhausted, Reopen>;

/// Whether nobody needs to be asked: everything can be had, or what was asked for can't. Nothing:
/// it depends on answers. Throws LimitReached on a cancel and where the time is up.
std::optional<Decision> decideWithoutAnswers(Analysis& analysis, const Options& options);

/// What follows from the answers so far. Changes nothing but what the analysis remembers of its
/// searches. `ends_unsure`: what was answered "don't know" ends the dialogue now. Throws
/// LimitReached on a cancel and where the time is up.
Decision decide(const Dialogue& dialogue, Analysis& analysis, const Options& options,
                bool ends_unsure);

/// The same where it is settled that neither a plan nor a proof ends the dialogue yet.
Decision nextQuestion(const Dialogue& dialogue, Analysis& analysis, const Options& options);

/// Under UnsurePolicy::Abort: what the person is not sure of ends the dialogue.
Blocked blockedAtOnce(const Dialogue& dialogue, const Analysis& analysis);

/// Whether some conflict is known of which nothing was answered NO.
bool anyLive(const Dialogue& dialogue, const Analysis& analysis);

}  // namespace goal_alignment::session
