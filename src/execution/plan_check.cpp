// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/plan_check.h"

#include <fmt/format.h>
#include <ros/names.h>

#include "goal_alignment/any_message/message_codec.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/execution/facts_watch.h"
#include "goal_alignment/execution/simulated_frames.h"
#include "goal_alignment/pddl/near_name.h"
#include "goal_alignment/ros_common/message_conversion.h"

namespace goal_alignment::execution {
namespace {

// What stands in a PDDL name may be more than roscpp takes, which it would say in mid-plan.
void checkServer(const std::string& name, const YAML::Node& node, const std::string& source) {
  std::string why_not = "it is private to a node";
  if (name.rfind('~', 0) != 0 && ros::names::validate(name, why_not)) return;
  YamlReader(source).failAt(node.Mark(),
                            fmt::format("{} can't be a name in ROS: {}", inQuotes(name), why_not));
}

// Once the step is done it would be too late to find them wrong.
void checkExpected(const any_message::MessageDefinition& definition, const StepRule& rule,
                   const any_message::Arguments& arguments, any_message::MessageTypes& types) {
  for (const auto& [path, expected] : rule.success)
    any_message::checkValue(types, definition, path, expected, arguments);
}

void checkStep(const ActionDispatch& step, const StepRule& rule, const StepMapping& mapping,
               any_message::MessageTypes& types) {
  const any_message::Arguments arguments(step, mapping.tables, mapping.source);
  failureFacts(step, rule, mapping);
  if (rule.name.IsScalar()) checkServer(arguments.fill(rule.name), rule.name, mapping.source);
  for (const FrameMove& move : rule.moves) {
    arguments.fill(move.frame);
    if (!move.parent.IsNull()) arguments.fill(move.parent);
    if (!move.to.IsNull()) poseOf(arguments.resolve(move.to), mapping.source);
  }
  if (rule.action) {
    any_message::encode(types, rule.action->goal, rule.fields, arguments, {});
    checkExpected(rule.action->result, rule, arguments, types);
  }
  if (rule.service) {
    any_message::encode(types, rule.service->request, rule.fields, arguments, {});
    checkExpected(rule.service->response, rule, arguments, types);
  }
}

std::string silenceOn(const std::string& action, const StepMapping& mapping) {
  if (mapping.source.empty()) return "there is no mapping";
  std::vector<std::string> known;
  for (const auto& rule : mapping.rules)
    known.push_back(rule.first);
  return mapping.source + " has no such action" + pddl::suggestion(action, known);
}

}  // namespace

std::string faultOf(const Plan& plan) {
  if (plan.steps.empty() && plan.plan_id == 0) return "this is no plan: plan_id is 0";
  for (std::size_t index = 0; index < plan.steps.size(); ++index) {
    const ActionDispatch& step = plan.steps[index];
    if (step.name.empty()) return fmt::format("step {} has no name", index + 1);
    if (step.action_id != static_cast<int>(index)) {
      return fmt::format("step {} has action_id {}, expected {}", index + 1, step.action_id, index);
    }
  }
  try {
    ros_common::toLiterals(plan.guaranteed, "guaranteed");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

std::string mappingFault(const Plan& plan, const StepMapping& mapping,
                         any_message::MessageTypes& types) {
  for (const ActionDispatch& step : plan.steps) {
    const StepRule* rule = mapping.find(step.name);
    if (rule == nullptr) {
      return fmt::format("nothing says how to carry out step {} {}: {}", step.action_id + 1,
                         textOf(step), silenceOn(step.name, mapping));
    }
    try {
      checkStep(step, *rule, mapping, types);
    } catch (const std::exception& error) {
      return fmt::format("step {} {}: {}", step.action_id + 1, textOf(step), error.what());
    }
  }
  return {};
}

std::vector<Literal> failureFacts(const ActionDispatch& step, const StepRule& rule,
                                  const StepMapping& mapping) {
  const any_message::Arguments arguments(step, mapping.tables, mapping.source);
  std::vector<Literal> facts;
  for (const YAML::Node& fact : rule.failure_facts) {
    try {
      facts.push_back(Literal::parse(arguments.fill(fact)));
    } catch (const std::invalid_argument& error) {
      YamlReader(mapping.source).failAt(fact.Mark(), error.what());
    }
  }
  return facts;
}

}  // namespace goal_alignment::execution
