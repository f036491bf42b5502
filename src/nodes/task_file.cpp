// SPDX-License-Identifier: BSD-3-Clause
#include "task_file.h"

#include <functional>
#include <stdexcept>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/package_files.h"

namespace goal_alignment::nodes {
namespace {

constexpr const char* kWhat = "a map with task_id, person, goal and plan";

class TaskReader {
 public:
  explicit TaskReader(const std::string& source_name) : reader_(source_name) {}

  HumanTask read(const std::string& text) {
    bool empty = true;
    reader_.load(text, [&](const YAML::Node& root) {
      empty = false;
      fields_ = reader_.fields(root, kWhat, {"task_id", "person", "goal", "plan"});
      task_.task_id = word("task_id");
      task_.person = word("person");
      readList("goal", "a fluent such as (on a b)", [this](const std::string& fluent) {
        const Literal literal = Literal::parse(fluent);
        Fluent& message = task_.goal.emplace_back();
        message.name = literal.atom.name;
        message.args = literal.atom.arguments;
        message.negated = literal.negated;
      });
      readList("plan", "an action such as (go hall kitchen)", [this](const std::string& action) {
        const GroundName ground = pddl::parseStep({inQuotes(action), action});
        PlanStep& message = task_.plan.emplace_back();
        message.name = ground.name;
        message.args = ground.arguments;
      });
    });
    if (empty) reader_.fail({}, kWhat, "nothing");
    return task_;
  }

 private:
  std::string word(const std::string& key) const {
    const auto found = fields_.find(key);
    return found == fields_.end() ? "" : reader_.text(found->second, key);
  }

  void readList(const std::string& key, const std::string& what,
                const std::function<void(const std::string&)>& take) const {
    const auto found = fields_.find(key);
    if (found == fields_.end()) return;
    reader_.expectList(found->second, "a list");
    for (const YAML::Node& entry : found->second) {
      try {
        take(reader_.text(entry, what));
      } catch (const std::invalid_argument& error) {
        reader_.failAt(entry.Mark(), error.what());
      } catch (const pddl::InputError& error) {
        reader_.failAt(entry.Mark(), error.what());
      }
    }
  }

  YamlReader reader_;
  YamlReader::Fields fields_;
  HumanTask task_;
};

}  // namespace

HumanTask taskOfYaml(const std::string& text, const std::string& source_name) {
  return TaskReader(source_name).read(text);
}

HumanTask taskOfFile(const std::string& file) {
  const pddl::Source source = pddl::readFile(ros_common::resolveFile(file));
  return taskOfYaml(source.text, source.name);
}

}  // namespace goal_alignment::nodes
