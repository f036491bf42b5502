// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::cli {

/// The files of one instance; an empty name means that there is none.
struct InstanceFiles {
  std::string robot_domain;
  std::string robot_problem;
  std::string human_domain;
  std::string human_problem;
  std::string human_plan;
  std::string true_goal;
  std::string phrases;  ///< phrases.yaml: how questions are worded

  /// The files of an instance folder. Throws pddl::InputError where one but the true goal and the
  /// phrases is missing.
  static InstanceFiles of(const std::string& folder);
};

/// Reads the models' texts and the human plan. Throws pddl::InputError.
session::Input readInput(const InstanceFiles& files);

/// Answers as a person with this true goal would.
class ScriptedOracle {
 public:
  /// Throws pddl::InputError.
  explicit ScriptedOracle(const std::string& true_goal_file);
  session::AnswerKind answer(const Literal& fluent) const;

 private:
  std::set<Literal> true_goal_;
};

}  // namespace goal_alignment::cli
