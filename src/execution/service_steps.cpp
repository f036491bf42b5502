// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "goal_alignment/execution/graph_view.h"
#include "goal_alignment/execution/steps.h"
#include "goal_alignment/ros_common/stamp.h"
#include "success.h"

namespace goal_alignment::execution {

namespace {

// What services such as std_srvs/Trigger say of themselves.
std::string reasonIn(const StepTry& attempt, const any_message::MessageDefinition& definition,
                     const any_message::Bytes& message) {
  constexpr const char* kReason = "message";
  const any_message::MessageField* const field = definition.find(kReason);
  const bool has_reason = field != nullptr && field->type == "string" &&
                          field->length == any_message::MessageField::kSingle;
  std::string found;
  if (has_reason) {
    any_message::matches(attempt.types, definition, message, kReason, YAML::Node(""),
                         attempt.arguments, found);
  }
  return found.empty() ? "" : ": " + found;
}

}  // namespace

StepEnd checkSuccess(const StepTry& attempt, const any_message::MessageDefinition& definition,
                     const std::optional<any_message::Bytes>& message, const std::string& name) {
  if (!attempt.rule.success.empty() && !message) {
    return {StepEnd::Kind::Failed, fmt::format("{} gave no result", name)};
  }
  for (const auto& [path, expected] : attempt.rule.success) {
    std::string found;
    if (any_message::matches(attempt.types, definition, *message, path, expected, attempt.arguments,
                             found)) {
      continue;
    }
    return {StepEnd::Kind::Failed, fmt::format("{} answered with {} {}{}", name, path, found,
                                               reasonIn(attempt, definition, *message))};
  }
  return {};
}

std::string ServiceSteps::missing(const StepRule& rule, const any_message::Arguments& arguments,
                                  any_message::Clock::time_point until) {
  const std::string name = arguments.fill(rule.name);
  if (services_.isOffered(name, until)) return "";
  const auto graph = GraphView::now();
  return fmt::format("nobody offers the service {}{}", name,
                     graph ? graph->nearService(services_.resolved(name)) : "");
}

StepEnd ServiceSteps::run(const StepTry& attempt) {
  using Kind = any_message::ServiceCaller::Reply::Kind;
  const any_message::ServiceDefinition& type = *attempt.rule.service;
  const std::string name = attempt.arguments.fill(attempt.rule.name);
  const any_message::Bytes request = any_message::encode(
      attempt.types, type.request, attempt.rule.fields, attempt.arguments, ros_common::stampNow());
  attempt.dispatch();
  const any_message::ServiceCaller::Reply reply =
      services_.call(name, type.md5, request,
                     {attempt.rule.server_timeout, attempt.options.cancel_timeout, attempt.end});
  switch (reply.kind) {
    case Kind::Answered:
      return checkSuccess(attempt, type.response, reply.response, name);
    case Kind::Failed:
      return {StepEnd::Kind::Failed,
              fmt::format("the call of {} failed: it refused it or died, or is no {}", name,
                          type.type)};
    case Kind::NoServer:
      return {StepEnd::Kind::Failed, fmt::format("nobody offers the service {}", name)};
    case Kind::TooMany:
      return {StepEnd::Kind::Failed,
              fmt::format("{} is not called: too many calls of services never ended", name)};
    case Kind::TimedOut:  // the call can't be withdrawn
      return {StepEnd::Kind::TimedOut, name, false};
    case Kind::Interrupted:
      break;
  }
  return {StepEnd::Kind::Interrupted, ""};
}

}  // namespace goal_alignment::execution
