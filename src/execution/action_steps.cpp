// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib_msgs/GoalStatus.h>
#include <fmt/format.h>

#include "goal_alignment/execution/graph_view.h"
#include "goal_alignment/execution/steps.h"
#include "goal_alignment/ros_common/stamp.h"
#include "success.h"

namespace goal_alignment::execution {
namespace {

using actionlib_msgs::GoalStatus;
using End = any_message::ActionClient::End;

const char* wordFor(std::uint8_t status) {
  switch (status) {
    case GoalStatus::ABORTED:
      return "aborted";
    case GoalStatus::REJECTED:
      return "rejected";
    case GoalStatus::PREEMPTED:
    case GoalStatus::RECALLED:
      return "preempted";
    default:
      return "lost";
  }
}

StepEnd treat(const StepTry& attempt, const std::string& name, const End& end) {
  switch (end.kind) {
    case End::Kind::NoServer:
      return {StepEnd::Kind::Failed, fmt::format("nobody offers the action {} of type {}", name,
                                                 attempt.rule.action->type)};
    case End::Kind::Lost:
      return {StepEnd::Kind::Failed, fmt::format("the server of {} went away", name)};
    case End::Kind::TimedOut:
      return {StepEnd::Kind::TimedOut, end.text.empty() ? name : name + ": " + end.text,
              end.is_over};
    case End::Kind::Interrupted:
      return {StepEnd::Kind::Interrupted, end.text.empty() ? "" : name + ": " + end.text,
              end.is_over};
    case End::Kind::Ended:
      break;
  }
  if (end.status != GoalStatus::SUCCEEDED) {
    return {StepEnd::Kind::Failed, fmt::format("{} {} the goal{}{}", name, wordFor(end.status),
                                               end.text.empty() ? "" : ": ", end.text)};
  }
  return checkSuccess(attempt, attempt.rule.action->result, end.result, name);
}

}  // namespace

any_message::ActionClient& ActionSteps::clientOf(const std::string& name,
                                                 const any_message::ActionDefinition& type) {
  auto& client = clients_[node_.resolveName(name)];
  if (client && client->type().md5 != type.goal_message_md5) {
    // The mapping was corrected. A topic can't be advertised with two types.
    client.reset();
  }
  if (!client) {
    client = std::make_unique<any_message::ActionClient>(
        node_, name,
        any_message::ActionClient::GoalType{type.type + "ActionGoal", type.goal_message_md5,
                                            type.goal_message_text},
        wait_);
  }
  return *client;
}

void ActionSteps::approach(const StepRule& rule, const any_message::Arguments& arguments) {
  clientOf(arguments.fill(rule.name), *rule.action);
}

std::string ActionSteps::missing(const StepRule& rule, const any_message::Arguments& arguments,
                                 any_message::Clock::time_point until) {
  const std::string name = arguments.fill(rule.name);
  const any_message::ActionClient& client = clientOf(name, *rule.action);
  if (wait_.waitUntil(until, [&] { return client.connected(); }) ==
      any_message::WaitPoint::Woken::Holds)
    return "";
  const auto graph = GraphView::now();
  return fmt::format("nobody offers the action {} of type {}{}", name, rule.action->type,
                     graph ? graph->nearAction(node_.resolveName(name), rule.action->type) : "");
}

StepEnd ActionSteps::run(const StepTry& attempt) {
  const any_message::ActionDefinition& type = *attempt.rule.action;
  const std::string name = attempt.arguments.fill(attempt.rule.name);
  const any_message::Bytes goal = any_message::encode(attempt.types, type.goal, attempt.rule.fields,
                                                      attempt.arguments, ros_common::stampNow());
  attempt.dispatch();
  const any_message::ActionClient::Limits limits{attempt.rule.server_timeout,
                                                 attempt.options.cancel_timeout, attempt.end};
  return treat(attempt, name, clientOf(name, type).run(goal, ros_common::stampNow(), limits));
}

}  // namespace goal_alignment::execution
