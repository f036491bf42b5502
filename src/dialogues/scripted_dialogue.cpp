// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/scripted_dialogue.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <chrono>
#include <stdexcept>
#include <vector>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/package_files.h"
#include "goal_alignment/ros_common/parameter_reader.h"

namespace goal_alignment::dialogues {
namespace {

constexpr double kLongestDelay = 86400;  // seconds

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// A list, alone or under the key `true_goal`.
std::vector<Literal> literalsOfYaml(const pddl::Source& source) {
  const YamlReader reader(source.name);
  std::vector<Literal> literals;
  reader.load(source.text, [&](const YAML::Node& root) {
    YAML::Node list = root;
    if (root.IsMap()) list.reset(reader.fields(root, "a map", {"true_goal"})["true_goal"]);
    reader.expectList(list, "a list of fluents");
    for (const YAML::Node& entry : list) {
      try {
        literals.push_back(Literal::parse(reader.text(entry, "a fluent such as (on a b)")));
      } catch (const std::invalid_argument& error) {
        reader.failAt(entry.Mark(), error.what());
      }
    }
  });
  return literals;
}

TrueGoal readTrueGoalFile(const std::string& file) {
  const bool yaml = endsWith(file, ".yaml") || endsWith(file, ".yml");
  const pddl::Source source = pddl::readFile(file);
  const std::vector<Literal> literals = yaml ? literalsOfYaml(source) : pddl::parseLiterals(source);
  return {literals.begin(), literals.end()};
}

// A launch file passes on an argument that was not given as an empty text.
bool isMissing(XmlRpc::XmlRpcValue& true_goal) {
  if (!true_goal.valid()) return true;
  return true_goal.getType() == XmlRpc::XmlRpcValue::TypeString &&
         static_cast<std::string&>(true_goal).empty();
}

}  // namespace

TrueGoal readTrueGoal(const XmlRpc::XmlRpcValue& parameter) {
  using XmlRpc::XmlRpcValue;
  XmlRpcValue value = parameter;  // XmlRpcValue gives its contents away only when not const
  if (value.getType() == XmlRpcValue::TypeString) {
    return readTrueGoalFile(ros_common::resolveFile(static_cast<std::string&>(value)));
  }
  if (value.getType() != XmlRpcValue::TypeArray) {
    throw std::invalid_argument("expected a file name or a list of fluents");
  }
  std::vector<std::string> texts;
  for (int i = 0; i < value.size(); ++i) {
    if (value[i].getType() != XmlRpcValue::TypeString) {
      throw std::invalid_argument(fmt::format("entry {} is not a text such as \"(on a b)\"", i));
    }
    texts.push_back(static_cast<std::string&>(value[i]));
  }
  const std::vector<Literal> literals = ros_common::toLiterals(texts);
  return {literals.begin(), literals.end()};
}

AskHuman::Response answerFor(const Question& question, const TrueGoal& true_goal) {
  AskHuman::Response response;
  response.question_id = question.question_id;
  for (const Literal& fluent : ros_common::toLiterals(question.fluents, "question.fluents")) {
    if (true_goal.count(fluent) > 0) response.fluents.push_back(fluent.text());
  }
  response.answer = response.fluents.empty() ? AskHuman::Response::NO : AskHuman::Response::YES;
  return response;
}

ScriptedDialogue::ScriptedDialogue(ros::NodeHandle node, const ros::NodeHandle& private_node)
    : watch_(node), diagnostics_(node, private_node) {
  XmlRpc::XmlRpcValue values;
  private_node.getParam(private_node.getNamespace(), values);
  ros_common::ParameterReader(values, private_node.getNamespace())
      .read("delay", delay_, 0, kLongestDelay);
  XmlRpc::XmlRpcValue true_goal;
  private_node.getParam("true_goal", true_goal);
  if (isMissing(true_goal)) {
    throw std::invalid_argument(fmt::format(
        "the parameter {} is missing: the file, or the list, of the fluents that are wanted; "
        "goal_alignment.launch takes it as the argument true_goal",
        private_node.resolveName("true_goal")));
  }
  true_goal_ = readTrueGoal(true_goal);
  service_ = node.advertiseService(ros_common::kAskHumanService, &ScriptedDialogue::ask, this);
}

bool ScriptedDialogue::ask(AskHuman::Request& request, AskHuman::Response& response) {
  const DialogueDiagnostics::Turn turn(diagnostics_, request, response);
  const Question& question = request.question;
  response.answer = AskHuman::Response::NONE;
  response.question_id = question.question_id;
  if (watch_.waitUntilGone(question, std::chrono::duration<double>(delay_))) return true;
  try {
    response = answerFor(question, true_goal_);
  } catch (const std::invalid_argument& error) {
    ROS_WARN("can't answer question %u: %s", question.question_id, error.what());
    return true;
  }
  response.answered_by = "scripted_dialogue";
  ROS_INFO("question %u: %s: %s", question.question_id, question.text.c_str(),
           response.answer == AskHuman::Response::YES ? "yes" : "no");
  return true;
}

}  // namespace goal_alignment::dialogues
