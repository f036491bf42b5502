// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/cli/instance.h"

#include <algorithm>

#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/parser.h"

namespace goal_alignment::cli {

namespace {

using Path = std::filesystem::path;

constexpr const char* kRobotDomain = "robot_domain.pddl";
constexpr const char* kHumanPlan = "human_plan.txt";

bool has(const Path& folder, const char* name) {
  std::error_code error;
  return std::filesystem::exists(folder / name, error);
}

// `a/b/`, `b` and `.` have parents, too.
Path parentOf(const Path& folder) {
  const Path whole = std::filesystem::absolute(folder / "").lexically_normal().parent_path();
  return whole.parent_path();
}

// Empty where it is in neither folder.
std::string fileOf(const Path& folder, const char* name) {
  if (has(folder, name)) return (folder / name).string();
  const Path lent = parentOf(folder);
  return has(lent, name) ? (lent / name).string() : std::string();
}

std::string neededFileOf(const Path& folder, const char* name) {
  std::string file = fileOf(folder, name);
  if (!file.empty()) return file;
  throw pddl::InputError(
      folder.string(), {},
      std::string("no ") + name + " here, nor in the folder above, " + parentOf(folder).string());
}

bool lends(const Path& folder) {
  if (has(folder, kHumanPlan)) return false;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_directory() && has(entry.path(), kHumanPlan)) return true;
  }
  return false;
}

bool isInstance(const Path& folder) {
  return has(folder, kHumanPlan) || (has(folder, kRobotDomain) && !lends(folder));
}

}  // namespace

InstanceFiles InstanceFiles::of(const std::string& folder) {
  const Path base(folder);
  std::error_code error;
  if (!std::filesystem::is_directory(base, error)) {
    throw pddl::InputError(folder, {}, "expected an instance folder");
  }
  return {neededFileOf(base, kRobotDomain),
          neededFileOf(base, "robot_problem.pddl"),
          neededFileOf(base, "human_domain.pddl"),
          neededFileOf(base, "human_problem.pddl"),
          neededFileOf(base, kHumanPlan),
          fileOf(base, "true_goal.txt"),
          fileOf(base, "phrases.yaml")};
}

std::vector<Path> instanceFoldersBelow(const Path& root) {
  std::vector<Path> folders;
  if (isInstance(root)) folders.push_back(root);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.is_directory() && isInstance(entry.path())) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

pddl::Model readModel(const std::string& domain_file, const std::string& problem_file) {
  const pddl::Source domain = pddl::readFileOrPipe(domain_file);
  return pddl::readModel(domain, pddl::readFileOrPipe(problem_file));
}

session::Input readInput(const InstanceFiles& files) {
  session::Input input;
  input.robot_domain = pddl::readFileOrPipe(files.robot_domain);
  input.robot_problem = pddl::readFileOrPipe(files.robot_problem);
  input.human_domain = pddl::readFileOrPipe(files.human_domain);
  input.human_problem = pddl::readFileOrPipe(files.human_problem);
  input.human_plan = pddl::parsePlan(pddl::readFileOrPipe(files.human_plan)).steps;
  return input;
}

ScriptedOracle::ScriptedOracle(const std::string& true_goal_file) {
  for (Literal& literal : pddl::parseLiterals(pddl::readFileOrPipe(true_goal_file))) {
    true_goal_.insert(std::move(literal));
  }
}

session::AnswerKind ScriptedOracle::answer(const Literal& fluent) const {
  return true_goal_.count(fluent) > 0 ? session::AnswerKind::Yes : session::AnswerKind::No;
}

}  // namespace goal_alignment::cli
