// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/cli/instance.h"

#include <filesystem>

#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/parser.h"

namespace goal_alignment::cli {

InstanceFiles InstanceFiles::of(const std::string& folder) {
  const std::filesystem::path base(folder);
  std::error_code error;
  if (!std::filesystem::is_directory(base, error)) {
    throw pddl::InputError(folder, {}, "expected an instance folder");
  }
  const auto file = [&](const char* name) { return (base / name).string(); };
  InstanceFiles files = {file("robot_domain.pddl"), file("robot_problem.pddl"),
                         file("human_domain.pddl"), file("human_problem.pddl"),
                         file("human_plan.txt"),    file("true_goal.txt"),
                         file("phrases.yaml")};
  for (std::string* optional : {&files.true_goal, &files.phrases})
    if (!std::filesystem::exists(*optional, error)) optional->clear();
  return files;
}

session::Input readInput(const InstanceFiles& files) {
  session::Input input;
  input.robot_domain = pddl::readFile(files.robot_domain);
  input.robot_problem = pddl::readFile(files.robot_problem);
  input.human_domain = pddl::readFile(files.human_domain);
  input.human_problem = pddl::readFile(files.human_problem);
  input.human_plan = pddl::parsePlan(pddl::readFile(files.human_plan)).steps;
  return input;
}

ScriptedOracle::ScriptedOracle(const std::string& true_goal_file) {
  for (Literal& literal : pddl::parseLiterals(pddl::readFile(true_goal_file))) {
    true_goal_.insert(std::move(literal));
  }
}

session::AnswerKind ScriptedOracle::answer(const Literal& fluent) const {
  return true_goal_.count(fluent) > 0 ? session::AnswerKind::Yes : session::AnswerKind::No;
}

}  // namespace goal_alignment::cli
