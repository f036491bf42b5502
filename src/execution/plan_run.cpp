// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/plan_run.h"

#include <fmt/format.h>
#include <ros/console.h>
#include <ros/names.h>

#include <utility>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_interface/message_conversion.h"
#include "goal_alignment/ros_interface/package_files.h"
#include "goal_alignment/ros_interface/stamp.h"

namespace goal_alignment::execution {
namespace {

using Verdict = RobotWatch::Verdict;

constexpr int kMostFailures = 2;                     // of one ground action, each after its retries
constexpr std::chrono::milliseconds kTryPause{200};  // between two tries of a step
constexpr std::chrono::milliseconds kLookPause{100};  // between two looks at the facts

GroundName groundOf(const ActionDispatch& step) {
  GroundName ground{toLower(step.name), {}};
  for (const auto& parameter : step.parameters)
    ground.arguments.push_back(toLower(parameter.value));
  return ground;
}

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

std::string textOf(const ActionDispatch& step) {
  std::string text = "(" + step.name;
  for (const auto& parameter : step.parameters)
    text += " " + parameter.value;
  return text + ")";
}

std::string faultOf(const Plan& plan) {
  if (plan.steps.empty() && plan.plan_id == 0) return "this is no plan: plan_id is 0";
  for (std::size_t index = 0; index < plan.steps.size(); ++index) {
    const ActionDispatch& step = plan.steps[index];
    if (step.name.empty()) return fmt::format("step {} has no name", index);
    if (step.action_id != static_cast<int>(index)) {
      return fmt::format("step {} has action_id {}, expected its index", index, step.action_id);
    }
  }
  try {
    ros_interface::toLiterals(plan.guaranteed, "guaranteed");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

PlanRun::PlanRun(const RunParts& parts, const StepMapping& mapping, const ExecutorOptions& options,
                 Tell tell)
    : parts_(parts), mapping_(mapping), options_(options), tell_(std::move(tell)) {}

std::string PlanRun::mappingFault(const Plan& plan) const {
  for (const ActionDispatch& step : plan.steps) {
    const StepRule* rule = mapping_.find(step.name);
    if (rule == nullptr) {
      return fmt::format("nothing says how to carry out {}: {}", about(step),
                         mapping_.source.empty() ? "there is no mapping"
                                                 : mapping_.source + " has no such action");
    }
    const Arguments arguments(step, mapping_.tables, mapping_.source);
    try {
      failureFacts(step, *rule);
      if (rule->name.IsScalar()) checkServer(arguments.fill(rule->name), rule->name);
      for (const FrameMove& move : rule->moves) {
        arguments.fill(move.frame);
        if (!move.parent.IsNull()) arguments.fill(move.parent);
        if (!move.to.IsNull()) poseOf(arguments.resolve(move.to), mapping_.source);
      }
      if (rule->action) {
        encode(parts_.types, rule->action->goal, rule->fields, arguments, {});
        checkExpected(rule->action->result, *rule, arguments);
      }
      if (rule->service) {
        encode(parts_.types, rule->service->request, rule->fields, arguments, {});
        checkExpected(rule->service->response, *rule, arguments);
      }
    } catch (const std::exception& error) {
      return fmt::format("{}: {}", about(step), error.what());
    }
  }
  return {};
}

// What stands in a PDDL name may be more than roscpp takes, which it would say in mid-plan.
void PlanRun::checkServer(const std::string& name, const YAML::Node& node) const {
  std::string why_not = "it is private to a node";
  if (name.rfind('~', 0) != 0 && ros::names::validate(name, why_not)) return;
  YamlReader(mapping_.source)
      .failAt(node.Mark(), fmt::format("{} can't be a name in ROS: {}", inQuotes(name), why_not));
}

// Once the step is done it would be too late to find them wrong.
void PlanRun::checkExpected(const MessageDefinition& definition, const StepRule& rule,
                            const Arguments& arguments) const {
  for (const auto& [path, expected] : rule.success)
    checkValue(parts_.types, definition, path, expected, arguments);
}

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
  beginWatching();
  while (true) {
    Trouble trouble = walk();
    if (trouble.outcome == ExecutePlanResult::SUCCESS ||
        trouble.outcome == ExecutePlanResult::CANCELED) {
      return resultOf(trouble);
    }
    ROS_WARN("%s", trouble.reason.c_str());
    const std::string why_not = planAnew(trouble);
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

ExecutePlanResult PlanRun::resultOf(const Trouble& trouble) const {
  ExecutePlanResult result;
  result.outcome = trouble.outcome;
  result.failed_step = trouble.step;
  result.reason = trouble.reason;
  result.plan = plan_;
  result.replans = static_cast<std::uint32_t>(replans_);
  result.done = done_;
  return result;
}

void PlanRun::beginWatching() {
  unwatched_ = "its preconditions are not watched";
  if (!options_.watch) return;
  if (plan_.session_id.empty()) return stopWatching("the plan names no session of an aligner");
  const auto file = [this](const std::string& given, const char* key) {
    return ros_interface::resolveFile(given.empty() ? parts_.aligner.parameter(key) : given);
  };
  const auto facts = parts_.aligner.facts();
  if (!facts.known) return stopWatching(facts.message);
  try {
    watch_.emplace(pddl::readModel(pddl::readFile(file(options_.robot_domain, "robot_domain")),
                                   pddl::readFile(file(options_.robot_problem, "robot_problem"))));
  } catch (const std::exception& error) {
    stopWatching(error.what());
  }
}

void PlanRun::stopWatching(const std::string& why) {
  watch_.reset();
  if (parts_.wait.interrupted()) return;  // nobody is interested any more
  unwatched_ = "what is so is not known: " + why;
  ROS_WARN("the plan runs without a look at its preconditions: %s", why.c_str());
}

// Nothing: the plan is not watched any more.
std::optional<WorldState> PlanRun::world() {
  auto facts = parts_.aligner.facts();
  if (facts.known && facts.session_id == plan_.session_id) return std::move(facts.world);
  stopWatching(facts.known ? "the aligner is at another task by now" : facts.message);
  return std::nullopt;
}

PlanRun::Trouble PlanRun::walk() {
  for (const ActionDispatch& step : plan_.steps) {
    Trouble trouble = awaitPrecondition(step);
    if (trouble.outcome == ExecutePlanResult::SUCCESS) trouble = carryOut(step);
    if (trouble.outcome != ExecutePlanResult::SUCCESS) return trouble;
  }
  return awaitGoal();
}

PlanRun::Trouble PlanRun::awaitPrecondition(const ActionDispatch& step) {
  const GroundName action = groundOf(step);
  Trouble trouble = awaitFinding(
      [&](const WorldState& now) {
        before_ = now;
        return watch_->precondition(action, now);
      },
      step.action_id, ExecutePlanResult::PRECONDITION_FALSE, about(step) + " can't begin");
  if (trouble.outcome == ExecutePlanResult::PRECONDITION_FALSE)
    report(step, ActionFeedback::ACTION_PRECONDITION_FALSE, true);
  return trouble;
}

PlanRun::Trouble PlanRun::awaitGoal() {
  const std::vector<Literal> wanted = ros_interface::toLiterals(plan_.guaranteed, "guaranteed");
  return awaitFinding([&](const WorldState& now) { return watch_->literals(wanted, now); }, -1,
                      ExecutePlanResult::GOAL_NOT_REACHED, "the plan has come to its end, but");
}

// What tf tells may be a moment behind, so that only what stays so counts.
PlanRun::Trouble PlanRun::awaitFinding(
    const std::function<RobotWatch::Finding(const WorldState&)>& look, int step,
    std::uint16_t outcome, const std::string& about) {
  const auto patience = deadlineIn(options_.facts_patience);
  while (true) {
    if (!watch_ && step < 0) return {};  // everything is done
    if (parts_.wait.interrupted()) {
      return {ExecutePlanResult::CANCELED, step,
              step < 0 ? "stopped at the end" : fmt::format("stopped before step {}", step + 1), true};
    }
    if (!watch_) return {};
    const auto now = world();
    if (!now) continue;
    const RobotWatch::Finding finding = look(*now);
    if (finding.verdict == Verdict::Holds) return {};
    if (finding.verdict == Verdict::NoModel) {
      stopWatching(finding.reason);
    } else if (Clock::now() >= patience) {
      return {outcome, step, about + ": " + finding.reason, false};
    } else {
      parts_.wait.pauseUntil(std::min(patience, Clock::now() + kLookPause));
    }
  }
}

PlanRun::Trouble PlanRun::carryOut(const ActionDispatch& step) {
  const StepRule& rule = *mapping_.find(step.name);
  StepEnd end;
  for (int left = rule.retries; left >= 0; --left) {
    end = tryOnce(step, rule, left);
    if (end.kind == StepEnd::Kind::Succeeded) {
      treatSuccess(step);
      return {};
    }
    if (end.kind == StepEnd::Kind::Interrupted || left == 0) break;
    ROS_WARN("%s is tried again: %s", about(step).c_str(), end.reason.c_str());
    if (parts_.wait.pauseUntil(Clock::now() + kTryPause)) {
      end = {StepEnd::Kind::Interrupted, ""};
      break;
    }
  }
  return treatFailure(step, rule, end);
}

StepEnd PlanRun::tryOnce(const ActionDispatch& step, const StepRule& rule, int retries_left) {
  const Arguments arguments(step, mapping_.tables, mapping_.source);
  StepTry attempt{step,  rule, arguments, parts_.types, options_, timeoutIn(rule.timeout),
                  false, {},   {}};
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

void PlanRun::treatSuccess(const ActionDispatch& step) {
  done_.push_back(stepOf(step));
  if (!watch_ || parts_.aligner.tell(watch_->effects(groundOf(step), before_))) return;
  stopWatching("the aligner does not take what the step has changed");
}

PlanRun::Trouble PlanRun::treatFailure(const ActionDispatch& step, const StepRule& rule,
                                       const StepEnd& end) {
  const std::string because = end.reason.empty() ? "" : ": " + end.reason;
  if (end.kind == StepEnd::Kind::Interrupted) {
    return {ExecutePlanResult::CANCELED, step.action_id,
            fmt::format("stopped during {}{}", about(step), because), true};
  }
  if (watch_) tellFailure(step, rule);
  const bool again = ++failures_[textOf(step)] >= kMostFailures;
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

void PlanRun::tellFailure(const ActionDispatch& step, const StepRule& rule) {
  const std::vector<Literal> facts = failureFacts(step, rule);
  for (const Literal& fact : facts) {
    const RobotWatch::Finding finding = watch_->literals({fact}, before_);
    if (finding.verdict == Verdict::NoModel)
      ROS_WARN("%s: of the failure_facts one is no fact: %s", about(step).c_str(),
               finding.reason.c_str());
  }
  if (!parts_.aligner.tell(facts)) stopWatching("the aligner does not take what the failure tells");
}

std::vector<Literal> PlanRun::failureFacts(const ActionDispatch& step, const StepRule& rule) const {
  const Arguments arguments(step, mapping_.tables, mapping_.source);
  std::vector<Literal> facts;
  for (const YAML::Node& fact : rule.failure_facts) {
    try {
      facts.push_back(Literal::parse(arguments.fill(fact)));
    } catch (const std::invalid_argument& error) {
      YamlReader(mapping_.source).failAt(fact.Mark(), error.what());
    }
  }
  return facts;
}

std::string PlanRun::planAnew(const Trouble& trouble) {
  if (trouble.final) return "no other plan is sought for it";
  if (replans_ >= options_.max_replans)
    return options_.max_replans == 0 ? "no new plan is wanted (max_replans)"
                                     : fmt::format("there were {} new plans already", replans_);
  // Without the facts a new plan would begin where this one did.
  if (!watch_) return "no new plan, since " + unwatched_;
  tell(trouble.step, ActionFeedback::ACTION_FAILED, trouble.reason + "; I plan anew");
  std::string why_not;
  const auto result = parts_.aligner.planAnew(plan_.session_id, options_.cancel_patience, why_not);
  if (!result) return why_not;
  why_not = faultOf(result->plan);
  if (why_not.empty()) why_not = mappingFault(result->plan);
  if (!why_not.empty()) return "the new plan can't be run: " + why_not;
  ++replans_;
  plan_ = result->plan;
  ROS_INFO("a new plan of %zu steps", plan_.steps.size());
  tell(-1, ActionFeedback::ACTION_ENABLED, "", plan_);
  return "";
}

void PlanRun::dispatch(const ActionDispatch& step, const StepRule& rule) {
  ActionDispatch message = step;
  const std::chrono::duration<float> since_begin = Clock::now() - begin_;
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
