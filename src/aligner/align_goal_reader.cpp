// SPDX-License-Identifier: BSD-3-Clause
#include "align_goal_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/package_files.h"

namespace goal_alignment::aligner {
namespace {

pddl::Source fromFile(const std::string& file, const std::string& what) {
  if (file.empty()) throw GoalError(what + " names no file");
  return pddl::readFile(ros_common::resolveFile(file));
}

session::Input modelsOf(const AlignGoal& goal, const NodeOptions& options) {
  session::Input input;
  switch (goal.source) {
    case AlignGoal::PARAMS:
      return parameterModels(options);
    case AlignGoal::FILES:
      input.robot_domain = fromFile(goal.robot_domain, "robot_domain");
      input.robot_problem = fromFile(goal.robot_problem, "robot_problem");
      input.human_domain = fromFile(goal.human_domain, "human_domain");
      input.human_problem = fromFile(goal.human_problem, "human_problem");
      return input;
    case AlignGoal::TEXT:
      input.robot_domain = {"robot_domain", goal.robot_domain};
      input.robot_problem = {"robot_problem", goal.robot_problem};
      input.human_domain = {"human_domain", goal.human_domain};
      input.human_problem = {"human_problem", goal.human_problem};
      return input;
    default:
      throw GoalError(
          fmt::format("source is {}: expected PARAMS=0, FILES=1 or TEXT=2", int{goal.source}));
  }
}

// -1 is no limit, so the smaller of two limits is the smaller as unsigned numbers.
int smallerLimit(int a, int b) {
  return static_cast<int>(std::min(static_cast<unsigned>(a), static_cast<unsigned>(b)));
}

}  // namespace

session::Input inputOf(const AlignGoal& goal, const NodeOptions& options) {
  try {
    std::vector<Literal> wanted = ros_common::toLiterals(goal.task.goal, "task.goal");
    std::vector<GroundName> plan = ros_common::toActions(goal.task.plan, "task.plan");
    session::Input input = modelsOf(goal, options);
    input.goal = std::move(wanted);
    input.human_plan = std::move(plan);
    return input;
  } catch (const std::invalid_argument& error) {
    throw GoalError(error.what());
  }
}

session::Input parameterModels(const NodeOptions& options) {
  session::Input input;
  input.robot_domain = fromFile(options.robot_domain, "parameter ~robot_domain");
  input.robot_problem = fromFile(options.robot_problem, "parameter ~robot_problem");
  input.human_domain = fromFile(options.human_domain, "parameter ~human_domain");
  input.human_problem = fromFile(options.human_problem, "parameter ~human_problem");
  return input;
}

session::Options optionsOf(const AlignGoal& goal, const NodeOptions& options) {
  session::Options result = options.session;
  const double time_limit = goal.time_limit.toSec();
  if (time_limit < 0)
    throw GoalError(fmt::format("time_limit is {} s: it is negative", time_limit));
  if (time_limit > 0) result.time_limit = time_limit;
  if (goal.max_questions < -1) {
    throw GoalError(
        fmt::format("max_questions is {}: expected -1 (no limit) or more", goal.max_questions));
  }
  result.max_questions = smallerLimit(goal.max_questions, options.session.max_questions);
  if (goal.unsure_policy > AlignGoal::KEEP) {
    throw GoalError(
        fmt::format("unsure_policy is {}: expected AS_YES=0, DEFER=1, ABORT=2 or "
                    "KEEP=3",
                    int{goal.unsure_policy}));
  }
  if (goal.unsure_policy != AlignGoal::KEEP)
    result.unsure_policy = static_cast<session::UnsurePolicy>(goal.unsure_policy);
  else if (!goal.continue_session.empty())
    result.unsure_policy.reset();
  if (goal.max_group_size > 0) result.max_group_size = goal.max_group_size;
  result.negative_candidates = result.negative_candidates || goal.negative_candidates != 0;
  return result;
}

std::shared_ptr<const spatial_facts::Rules> rulesOf(const std::string& file) {
  if (file.empty()) return nullptr;
  try {
    const pddl::Source source = pddl::readFile(ros_common::resolveFile(file));
    return spatial_facts::Rules::fromYaml(source.text, source.name);
  } catch (const std::exception& error) {
    throw GoalError(fmt::format("parameter ~tf_facts: {}", error.what()));
  }
}

}  // namespace goal_alignment::aligner
