// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/Explain.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::aligner {

/// What ~explain speaks of: the session as it stood after its last step.
struct ExplanationContext {
  session::Snapshot snapshot;
  std::vector<Literal> open_question;                ///< empty: none is open
  std::string open_why;                              ///< as the question says it; may be empty
  std::vector<std::vector<Literal>> open_conflicts;  ///< that it rests on
  session::OutcomeCode outcome = session::OutcomeCode::None;  ///< None: it goes on
  std::vector<Literal>
      outcome_conflict;          ///< what the outcome rests on; empty: nothing, or none yet
  std::vector<GroundName> plan;  ///< where one was found
  std::vector<GroundName> human_plan;
  std::string human_plan_break;  ///< where it first fails for the robot
  phrasing::Phrases phrases;
};

/// Why each fluent is asked, or can't be had, or is of no account. No fluents: why the open
/// question is asked, or the conflict that the outcome rests on. `known` is false as long as the
/// search for conflicts may still bring up a reason.
Explain::Response explainWhy(const ExplanationContext& explained,
                             const std::vector<Literal>& fluents);

/// Why each fluent is not asked, and what becomes of it. No fluents: why the robot does not simply
/// follow the person's plan, or that it does.
Explain::Response explainWhyNot(const ExplanationContext& explained,
                                const std::vector<Literal>& fluents);

}  // namespace goal_alignment::aligner
