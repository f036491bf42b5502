// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <ros/time.h>

#include "goal_alignment/AlignResult.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/AlternativeGoal.h"
#include "goal_alignment/Candidate.h"
#include "goal_alignment/Conflict.h"
#include "goal_alignment/Fluent.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/PlanStep.h"
#include "goal_alignment/Question.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/session/session.h"

/// Core values to messages and back. Functions without state and without a ROS graph.
namespace goal_alignment::ros_common {

/// When each candidate was answered, which the core does not know.
using AnswerTimes = std::map<Literal, ros::Time>;

/// Whether the text is a PDDL name: not empty, without blanks, parentheses and the like.
bool isName(const std::string& text);

// Messages to core. Throw std::invalid_argument that names the field for a name or an argument
// that is no PDDL name (empty, blanks, parentheses, …): such a text would parse as something else.
Literal toLiteral(const Fluent& fluent);
std::vector<Literal> toLiterals(const std::vector<Fluent>& fluents, const std::string& field);
GroundName toAction(const PlanStep& step);
std::vector<GroundName> toActions(const std::vector<PlanStep>& steps, const std::string& field);
/// `(on a b)`, `on a b`, `(not (on a b))`.
std::vector<Literal> toLiterals(const std::vector<std::string>& texts);

// Core to messages.
Fluent toMessage(const Literal& literal, const phrasing::Phrases& phrases);
std::vector<Fluent> toMessage(const std::vector<Literal>& literals,
                              const phrasing::Phrases& phrases);
Candidate toMessage(const session::CandidateView& view, const phrasing::Phrases& phrases,
                    const AnswerTimes& times);
Conflict toMessage(const session::ConflictView& view, const phrasing::Phrases& phrases);
Question toMessage(const session::QuestionView& view, const phrasing::Phrases& phrases);
AlternativeGoal toMessage(const session::Alternative& alternative,
                          const phrasing::Phrases& phrases);

/// Fills what the snapshot knows: no header, session, outcome or texts.
AlignmentState toMessage(const session::Snapshot& snapshot, const phrasing::Phrases& phrases,
                         const AnswerTimes& times);

/// The phase of AlignmentState for a state of the session.
std::uint8_t phaseOf(session::State state);

/// A plan with its steps' parameters named as in the robot's model; no header.
Plan toMessage(const session::Session& session, std::int32_t plan_id,
               const phrasing::Phrases& phrases);

/// Outcome, message, conflict, alternatives and failing step; the rest is the caller's.
AlignResult toMessage(const session::Outcome& outcome, const phrasing::Phrases& phrases);

}  // namespace goal_alignment::ros_common
