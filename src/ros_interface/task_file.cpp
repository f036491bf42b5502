// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/task_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_interface/package_files.h"

namespace goal_alignment::ros_interface {
namespace {

using Texts = std::vector<std::string>;

HumanTask taskOf(const YAML::Node& root) {
  HumanTask task;
  task.task_id = root["task_id"].as<std::string>("");
  task.person = root["person"].as<std::string>("");
  // as() would take its default for a node of the wrong type, too.
  const auto list = [&](const char* key) {
    return root[key] && !root[key].IsNull() ? root[key].as<Texts>() : Texts{};
  };
  for (const std::string& text : list("goal")) {
    const Literal literal = Literal::parse(text);
    Fluent fluent;
    fluent.name = literal.atom.name;
    fluent.args = literal.atom.arguments;
    fluent.negated = literal.negated;
    task.goal.push_back(fluent);
  }
  for (const std::string& text : list("plan")) {
    const GroundName action = GroundName::parse(text);
    PlanStep step;
    step.name = action.name;
    step.args = action.arguments;
    task.plan.push_back(step);
  }
  return task;
}

}  // namespace

HumanTask taskOfYaml(const std::string& text, const std::string& source_name) {
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap()) {
      throw std::runtime_error(
          fmt::format("{}: expected a map with task_id, person, goal and plan", source_name));
    }
    return taskOf(root);
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", source_name, error.what()));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", source_name, error.what()));
  }
}

HumanTask taskOfFile(const std::string& file) {
  const pddl::Source source = pddl::readFile(resolveFile(file));
  return taskOfYaml(source.text, source.name);
}

}  // namespace goal_alignment::ros_interface
