// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "goal_alignment/AlignGoal.h"
#include "goal_alignment/session/options.h"
#include "goal_alignment/session/session.h"
#include "goal_alignment/spatial_facts/rules.h"
#include "node_options.h"

namespace goal_alignment::aligner {

/// A field of an Align goal that can't be used; what() names it.
class GoalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The models and the task of a goal, wherever it says they are. Reads files; parses nothing.
/// Throws GoalError, ParameterError, or pddl::InputError for a file that can't be read.
session::Input inputOf(const AlignGoal& goal, const NodeOptions& options);

/// The models alone that the parameters name; it throws the same.
session::Input parameterModels(const NodeOptions& options);

/// The session's options: the parameters, with what the goal says about them; no unsure_policy
/// where a session that goes on keeps its own. Throws GoalError.
session::Options optionsOf(const AlignGoal& goal, const NodeOptions& options);

/// The rules of the file; null for "". Throws GoalError.
std::shared_ptr<const spatial_facts::Rules> rulesOf(const std::string& file);

}  // namespace goal_alignment::aligner
