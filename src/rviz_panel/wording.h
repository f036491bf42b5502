// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <string>
#include <vector>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Candidate.h"
#include "goal_alignment/Fluent.h"

/// What the panel says about messages. Fluents and steps come as plain text, never as markup.
namespace goal_alignment::rviz_panel {

/// "(on a b)" or "(not (on a b))", as ~answer understands it.
QString pddlOf(const Fluent& fluent);
/// The spoken form where there is one, else "on: a, b" or "not so: on: a, b".
QString phraseOf(const Fluent& fluent);
QStringList phrasesOf(const std::vector<Fluent>& fluents);
/// "(wipe china-cup)".
QString pddlOf(const ActionDispatch& step);

/// The phrase with a capital first letter.
QString sentence(QString text);

/// Of Candidate: "wanted", "to be asked", …
QString stateWord(std::uint8_t candidate_state);
bool isAnswered(const Candidate& candidate);

/// One line on where the alignment stands.
QString phaseLine(const AlignmentState& state);
/// The task and whose it is; "" where neither is known.
QString titleOf(const std::string& task_id, const std::string& person);

bool isUnderWay(const AlignmentState& state);
/// DONE, and not by a plan.
bool endedWithoutPlan(const AlignmentState& state);

QString percent(double probability);

}  // namespace goal_alignment::rviz_panel
