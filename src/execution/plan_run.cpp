// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/plan_run.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <utility>

#include "goal_alignment/execution/mapping_check.h"

namespace goal_alignment::execution {
namespace {

constexpr int kMaxFailures = 2;                      // of one ground action, each after its retries
constexpr std::chrono::milliseconds kTryPause{200};  // between two tries of a step

PlanStep stepOf(const ActionDispatch& step) {
  PlanStep message;
  message.name = step.name;
  for (const auto& parameter : step.parameters)
    message.args.push_back(parameter.value);
  return message;
}

std::string about(const ActionDispatch& step) {
  return fmt::format("step {} {}", step.action_id + 1, textOf(step));
}

}  // namespace

PlanRun::PlanRun(const RunParts& parts, const StepMapping& mapping, const ExecutorOptions& options,
                 Tell tell)
    : parts_(parts),
      mapping_(mapping),
      options_(options),
      tell_(std::move(tell)),
      facts_(parts.aligner, parts.ledger, parts.wait, options) {}

ExecutePlanResult PlanRun::run(const Plan& plan) {
  plan_ = plan;
  try {
    return runOn();
  } catch (const std::exception& error) {
    ROS_ERROR("the plan broke off: %s", error.what());
    return resultOf({ExecutePlanResult::INTERNAL, -1, error.what(), true});
  }
}

ExecutePlanResult PlanRun::runOn() {
  facts_.begin(plan_);
  if (facts_.model() != nullptr) {
    for (const std::string& misfit : misfits(mapping_, *facts_.model()))
      parts_.warn_once(misfit);
  }
  while (true) {
    PlanFailure trouble = walk();
    if (trouble.outcome == ExecutePlanResult::SUCCESS ||
        trouble.outcome == ExecutePlanResult::CANCELED) {
      return resultOf(trouble);
    }
    ROS_WARN("%s", trouble.reason.c_str());
    const std::string why_not = replan(trouble);
    if (why_not.empty()) continue;
    if (parts_.wait.interrupted()) {
      trouble.outcome = ExecutePlanResult::CANCELED;
      trouble.reason += "; stopped while a new plan was sought";
    } else {
      trouble.reason += "; " + why_not;
    }
    return resultOf(trouble);
  }
}

ExecutePlanResult PlanRun::resultOf(const PlanFailure& trouble) const {
  ExecutePlanResult result;
  result.outcome = trouble.outcome;
  result.failed_step = trouble.step;
  result.reason = trouble.reason;
  result.plan = plan_;
  result.replans = static_cast<std::uint32_t>(replans_);
  result.done = done_;
  return result;
}

PlanRun::PlanFailure PlanRun::walk() {
  PlanFailure trouble = awaitServers();
  for (std::size_t index = 0; index < plan_.steps.size(); ++index) {
    if (trouble.outcome == ExecutePlanResult::SUCCESS) trouble = beforeStep(index);
    if (trouble.outcome == ExecutePlanResult::SUCCESS) trouble = carryOut(plan_.steps[index]);
  }
  return trouble.outcome == ExecutePlanResult::SUCCESS ? atTheEnd() : trouble;
}

// All of them have the same time, so that many that are missing are found out as soon as one.
PlanRun::PlanFailure PlanRun::awaitServers() {
  const auto until = any_message::deadlineIn(options_.servers_timeout);
  const auto begin = any_message::Clock::now();
  std::set<std::pair<StepKind, std::string>> seen;
  const auto forEach = [&](const auto& treat) {
    for (const ActionDispatch& step : plan_.steps) {
      const StepRule& rule = *mapping_.find(step.name);
      const any_message::Arguments arguments(step, mapping_.tables, mapping_.source);
      treat(step, rule, arguments, rule.name.IsScalar() ? arguments.fill(rule.name) : "");
    }
  };
  forEach([&](const auto& /*step*/, const StepRule& rule, const any_message::Arguments& arguments,
              const std::string& /*server*/) { runnerOf(rule.kind).approach(rule, arguments); });
  PlanFailure trouble;
  std::set<std::string> all_missing;
  forEach([&](const ActionDispatch& step, const StepRule& rule,
              const any_message::Arguments& arguments, const std::string& server) {
    const bool is_new = seen.insert({rule.kind, server}).second;
    if (!is_new || parts_.wait.interrupted()) return;
    const std::chrono::duration<double> patience(rule.server_timeout);
    const std::string missing = runnerOf(rule.kind).missing(
        rule, arguments,
        std::min(until,
                 begin + std::chrono::duration_cast<any_message::Clock::duration>(patience)));
    if (missing.empty()) return;
    all_missing.insert(missing);
    if (trouble.outcome == ExecutePlanResult::SUCCESS) {
      trouble = {ExecutePlanResult::STEP_FAILED, step.action_id,
                 fmt::format("{} can't be carried out: {}", about(step), missing),
                 !isAvoidable(rule, server)};
      if (!trouble.final) facts_.failed(step, failureFacts(step, rule, mapping_));
    } else {
      trouble.reason += fmt::format("; nor can {}: {}", about(step), missing);
    }
  });
  parts_.set_missing(all_missing);
  if (!parts_.wait.interrupted()) return trouble;
  return {ExecutePlanResult::CANCELED, 0, "stopped before step 1", true};
}

// A new plan can do without a server that the failure facts speak of as a whole. Else it would want
// the same one for the next best step.
bool PlanRun::isAvoidable(const StepRule& rule, const std::string& server) {
  if (rule.failure_facts.empty() || rule.stop_on_failure || !rule.name.IsScalar()) return false;
  const auto of_server = any_message::Arguments::namesIn(rule.name.Scalar());
  for (const YAML::Node& fact : rule.failure_facts) {
    for (const std::string& name : any_message::Arguments::namesIn(fact.Scalar())) {
      const bool is_shared = std::count(of_server.begin(), of_server.end(), name) > 0;
      if (!is_shared) return false;
    }
  }
  return given_up_.insert(server).second;
}

PlanRun::PlanFailure PlanRun::beforeStep(std::size_t index) {
  using Kind = FactsWatch::Look::Kind;
  const FactsWatch::Look look = facts_.beforeStep(plan_, index);
  const std::string stopped = fmt::format("stopped before step {}", index + 1);
  switch (look.kind) {
    case Kind::Interrupted:
      return {ExecutePlanResult::CANCELED, static_cast<int>(index), stopped, true};
    case Kind::End:
      return {ExecutePlanResult::GOAL_NOT_REACHED, -1,
              fmt::format("{}: at the end of the plan {}", stopped, look.reason), false};
    case Kind::Step:
      break;
    case Kind::Fine:
      return {};
  }
  const ActionDispatch& step = plan_.steps[look.step];
  report(step, ActionFeedback::ACTION_PRECONDITION_FALSE, true);
  const std::string later = look.step > index ? stopped + ": " : "";
  return {ExecutePlanResult::PRECONDITION_FALSE, step.action_id,
          fmt::format("{}{} can't begin{}: {}", later, about(step), later.empty() ? "" : " then",
                      look.reason),
          false};
}

PlanRun::PlanFailure PlanRun::atTheEnd() {
  using Kind = FactsWatch::Look::Kind;
  const FactsWatch::Look look = facts_.atTheEnd(plan_);
  if (look.kind == Kind::Fine) return {};
  if (look.kind == Kind::Interrupted)
    return {ExecutePlanResult::CANCELED, -1, "stopped at the end", true};
  return {ExecutePlanResult::GOAL_NOT_REACHED, -1,
          "the plan has come to its end, but: " + look.reason, false};
}

PlanRun::PlanFailure PlanRun::carryOut(const ActionDispatch& step) {
  const StepRule& rule = *mapping_.find(step.name);
  StepEnd end;
  for (int left = rule.retries; left >= 0; --left) {
    end = tryOnce(step, rule, left);
    if (end.kind == StepEnd::Kind::Succeeded) {
      done_.push_back(stepOf(step));
      facts_.succeeded(step);
      return {};
    }
    if (end.kind == StepEnd::Kind::Interrupted || left == 0) break;
    if (!end.is_over) {
      end.reason += "; it is not tried again, since that try is not over";
      break;
    }
    ROS_WARN("%s is tried again: %s", about(step).c_str(), end.reason.c_str());
    if (parts_.wait.pauseUntil(any_message::Clock::now() + kTryPause)) {
      end = {StepEnd::Kind::Interrupted, ""};
      break;
    }
  }
  return treatFailure(step, rule, end);
}

StepEnd PlanRun::tryOnce(const ActionDispatch& step, const StepRule& rule, int retries_left) {
  const any_message::Arguments arguments(step, mapping_.tables, mapping_.source);
  StepTry attempt{
      step,         rule,     arguments,
      parts_.types, options_, any_message::TimeLimit::after(rule.timeout, options_.clock),
      false,        {},       {}};
  attempt.is_to_fail = step.action_id == options_.failing_step && replans_ == 0;
  attempt.dispatch = [&] { dispatch(step, rule); };
  attempt.progress = [&](int status) { tell(step.action_id, status); };
  StepEnd end;
  try {
    end = runnerOf(rule.kind).run(attempt);
  } catch (const std::runtime_error& error) {  // of the mapping or of a type
    end = {StepEnd::Kind::Failed, error.what()};
  }
  // Of a dispatched step its component says how it ended, if it does.
  const bool told = rule.kind == StepKind::Dispatch &&
                    (end.kind == StepEnd::Kind::Succeeded || end.kind == StepEnd::Kind::Failed);
  const bool succeeded = end.kind == StepEnd::Kind::Succeeded;
  if (succeeded || retries_left == 0 || end.kind == StepEnd::Kind::Interrupted) {
    report(
        step,
        succeeded ? ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE : ActionFeedback::ACTION_FAILED,
        !told);
  }
  return end;
}

PlanRun::PlanFailure PlanRun::treatFailure(const ActionDispatch& step, const StepRule& rule,
                                           const StepEnd& end) {
  const std::string because = end.reason.empty() ? "" : ": " + end.reason;
  if (end.kind == StepEnd::Kind::Interrupted) {
    return {ExecutePlanResult::CANCELED, step.action_id,
            fmt::format("stopped during {}{}", about(step), because), true};
  }
  facts_.failed(step, failureFacts(step, rule, mapping_));
  const bool again = ++failures_[textOf(step)] >= kMaxFailures;
  const bool final = again || rule.stop_on_failure;
  const std::string more = again ? ", as it did before" : "";
  if (end.kind == StepEnd::Kind::TimedOut) {
    return {ExecutePlanResult::STEP_TIMED_OUT, step.action_id,
            fmt::format("{} took more than {} s{}{}", about(step), rule.timeout, more, because),
            final};
  }
  return {ExecutePlanResult::STEP_FAILED, step.action_id,
          fmt::format("{} failed{}{}", about(step), more, because), final};
}

std::string PlanRun::replan(const PlanFailure& trouble) {
  if (trouble.final) return "no other plan is sought for it";
  if (replans_ >= options_.max_replans)
    return options_.max_replans == 0 ? "no new plan is wanted (max_replans)"
                                     : fmt::format("there were {} new plans already", replans_);
  std::string why_not = facts_.whyNoNewPlan();
  if (!why_not.empty()) return "no new plan, since " + why_not;
  tell(trouble.step, ActionFeedback::ACTION_FAILED, trouble.reason + "; I plan anew");
  const auto result = parts_.aligner.replan(plan_.session_id, options_.cancel_timeout, why_not);
  if (!result) return why_not;
  why_not = faultOf(result->plan);
  if (why_not.empty()) why_not = mappingFault(result->plan, mapping_, parts_.types);
  if (!why_not.empty()) return "the new plan can't be run: " + why_not;
  ++replans_;
  plan_ = result->plan;
  ROS_INFO("a new plan of %zu steps", plan_.steps.size());
  tell(-1, ActionFeedback::ACTION_ENABLED, "", plan_);
  return "";
}

void PlanRun::dispatch(const ActionDispatch& step, const StepRule& rule) {
  ActionDispatch message = step;
  const std::chrono::duration<float> since_begin = any_message::Clock::now() - begin_;
  message.dispatch_time = since_begin.count();
  if (rule.duration) message.duration = static_cast<float>(*rule.duration);
  if (!rule.duration && rule.kind == StepKind::Simulated)
    message.duration = static_cast<float>(options_.step_duration);
  parts_.dispatches.publish(message);
  if (rule.kind != StepKind::Dispatch) report(step, ActionFeedback::ACTION_ENABLED, true);
}

void PlanRun::report(const ActionDispatch& step, int status, bool on_topic) {
  if (on_topic) {
    ActionFeedback message;
    message.action_id = step.action_id;
    message.plan_id = step.plan_id;
    message.status = status;
    parts_.feedback.publish(message);
  }
  tell(step.action_id, status);
}

void PlanRun::tell(int step, int status, const std::string& message, const Plan& new_plan) {
  ExecutePlanFeedback progress;
  progress.step = step;
  progress.status = static_cast<std::uint8_t>(status);
  progress.plan_id = plan_.plan_id;
  progress.message = message;
  progress.new_plan = new_plan;
  tell_(progress);
}

StepRunner& PlanRun::runnerOf(StepKind kind) const {
  switch (kind) {
    case StepKind::Action:
      return parts_.action;
    case StepKind::Service:
      return parts_.service;
    case StepKind::Dispatch:
      return parts_.dispatch;
    case StepKind::Simulated:
      break;
  }
  return parts_.simulated;
}

}  // namespace goal_alignment::execution
