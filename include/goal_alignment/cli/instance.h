// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"
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

  /// The files of an instance folder. What it lacks it takes from its parent folder, so that tasks
  /// in one domain need not repeat it. Throws pddl::InputError, which names both places, where one
  /// but the true goal and the phrases is in neither.
  static InstanceFiles of(const std::string& folder);
};

/// The instance folders at `root` and below it, sorted: those with a robot_domain.pddl or a
/// human_plan.txt of their own, but for folders without a plan that only lend their files to
/// others. Throws std::filesystem::filesystem_error.
std::vector<std::filesystem::path> instanceFoldersBelow(const std::filesystem::path& root);

/// Reads a model from its two files, each of which may be a pipe. Throws what pddl::readModel()
/// does.
pddl::Model readModel(const std::string& domain_file, const std::string& problem_file);

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
