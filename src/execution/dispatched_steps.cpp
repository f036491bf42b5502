// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <ros/console.h>
#include <ros/this_node.h>

#include "goal_alignment/execution/names.h"
#include "goal_alignment/execution/steps.h"

namespace goal_alignment::execution {
namespace {

constexpr std::uint32_t kQueueSize = 100;

std::string informationOf(const ActionFeedback& feedback) {
  std::string text;
  for (const auto& entry : feedback.information)
    text += fmt::format(" ({}: {})", entry.key, entry.value);
  return text;
}

bool isOver(int status) {
  return status != ActionFeedback::ACTION_ENABLED &&
         status != ActionFeedback::ACTION_DISPATCHED_TO_START_STATE;
}

bool isKnown(int status) {
  return !isOver(status) || status == ActionFeedback::ACTION_PRECONDITION_FALSE ||
         status == ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE ||
         status == ActionFeedback::ACTION_SUCCEEDED_TO_START_STATE ||
         status == ActionFeedback::ACTION_FAILED;
}

}  // namespace

DispatchedSteps::DispatchedSteps(ros::NodeHandle node, ros::Publisher dispatches,
                                 DispatchListeners& listeners, any_message::WaitPoint& wait)
    : dispatches_(std::move(dispatches)),
      listeners_(listeners),
      wait_(wait),
      feedback_(node.subscribe(kActionFeedbackTopic, kQueueSize, &DispatchedSteps::hear, this)) {}

void DispatchedSteps::hear(const ros::MessageEvent<const ActionFeedback>& event) {
  // What this node says about a try that timed out is not about the next one.
  if (event.getPublisherName() == ros::this_node::getName()) return;
  const ActionFeedback& feedback = *event.getConstMessage();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!isAbout(feedback, event.getPublisherName())) return;
    if (last_ && isOver(last_->status)) return;  // another component may still have its say
    if (!last_ && isOver(feedback.status) && mayBeLate(feedback)) {
      ROS_WARN("%s says how an earlier try of step %d has ended: that does not count for this one",
               event.getPublisherName().c_str(), feedback.action_id + 1);
      return;
    }
    if (!isKnown(feedback.status)) {
      ROS_WARN(
          "%s says of step %d the status %d, which ActionFeedback does not have: it counts as a "
          "failure",
          event.getPublisherName().c_str(), feedback.action_id + 1, feedback.status);
    }
    last_ = feedback;
    performer_ = event.getPublisherName();
  }
  wait_.notify();
}

bool DispatchedSteps::isAbout(const ActionFeedback& feedback, const std::string& from) {
  if (expected_ == nullptr) return false;
  // ROSPlan's C++ base class of components leaves the plan's id out; ours count from 1.
  const bool is_plan = feedback.plan_id == expected_->plan_id || feedback.plan_id == 0;
  if (is_plan && feedback.action_id == expected_->action_id) return true;
  // Of the steps before this one something may still be said.
  const bool is_past = is_plan && feedback.action_id < expected_->action_id;
  if (!is_past && warned_about_.insert(expected_->plan_id).second) {
    ROS_WARN(
        "%s tells about step %d of plan %d while step %d of plan %d is carried out: what it says "
        "of others does not count",
        from.c_str(), feedback.action_id + 1, feedback.plan_id, expected_->action_id + 1,
        expected_->plan_id);
  }
  return false;
}

void DispatchedSteps::expect(const ActionDispatch* step) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (expected_ != nullptr) {
    if (last_ && isOver(last_->status)) {
      unfinished_.erase(expected_->action_id);
    } else {
      unfinished_[expected_->action_id] = expected_->plan_id;
    }
  }
  expected_ = step;
  last_.reset();
  performer_.clear();
}

bool DispatchedSteps::mayBeLate(const ActionFeedback& feedback) const {
  const auto earlier = unfinished_.find(feedback.action_id);
  return earlier != unfinished_.end() &&
         (feedback.plan_id == 0 || feedback.plan_id == earlier->second);
}

std::optional<ActionFeedback> DispatchedSteps::heard() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

// Nobody who could carry it out hears what is dispatched any more.
bool DispatchedSteps::isOrphaned() const {
  std::string performer;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    performer = performer_;
  }
  return dispatches_.getNumSubscribers() == 0 || listeners_.hasLeft(performer);
}

void DispatchedSteps::cancel(const ActionDispatch& step) {
  ActionDispatch message;
  message.action_id = step.action_id;
  message.plan_id = step.plan_id;
  message.name = kCancelDispatch;
  dispatches_.publish(message);
}

StepEnd DispatchedSteps::treat(const StepTry& attempt, const ActionFeedback& feedback) const {
  const std::string& action = attempt.step.name;
  switch (feedback.status) {
    case ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE:
      return {};
    case ActionFeedback::ACTION_PRECONDITION_FALSE:
      return {StepEnd::Kind::Failed,
              fmt::format("the component of {} says that its precondition is false{}", action,
                          informationOf(feedback))};
    case ActionFeedback::ACTION_SUCCEEDED_TO_START_STATE:
      return {StepEnd::Kind::Failed, fmt::format("the component of {} went back to the start{}",
                                                 action, informationOf(feedback))};
    case ActionFeedback::ACTION_FAILED:
      return {StepEnd::Kind::Failed, fmt::format("the component of {} says that it failed{}",
                                                 action, informationOf(feedback))};
    default:
      return {StepEnd::Kind::Failed,
              fmt::format("the component of {} says the status {}, which ActionFeedback does not "
                          "have{}",
                          action, feedback.status, informationOf(feedback))};
  }
}

std::string DispatchedSteps::missing(const StepRule& /*rule*/,
                                     const any_message::Arguments& /*arguments*/,
                                     any_message::Clock::time_point until) {
  const auto isListening = [this] { return dispatches_.getNumSubscribers() > 0; };
  return wait_.waitUntil(until, isListening) == any_message::WaitPoint::Woken::Holds
             ? ""
             : fmt::format("nobody hears {}", dispatches_.getTopic());
}

StepEnd DispatchedSteps::run(const StepTry& attempt) {
  using Woken = any_message::WaitPoint::Woken;
  const auto isListening = [this] { return dispatches_.getNumSubscribers() > 0; };
  const any_message::TimeLimit patience =
      attempt.end.capped(any_message::deadlineIn(attempt.rule.server_timeout));
  const Woken found = wait_.waitUntil(patience, isListening);
  if (found == Woken::Interrupt) return {StepEnd::Kind::Interrupted, ""};
  if (found == Woken::Timeout) {
    return {StepEnd::Kind::Failed, fmt::format("nobody takes up the dispatched action {}: nobody "
                                               "hears {}",
                                               attempt.step.name, dispatches_.getTopic())};
  }
  expect(&attempt.step);
  const StepEnd end = await(attempt, patience);
  expect(nullptr);
  return end;
}

StepEnd DispatchedSteps::await(const StepTry& attempt, const any_message::TimeLimit& patience) {
  using Woken = any_message::WaitPoint::Woken;
  using Kind = StepEnd::Kind;
  attempt.dispatch();

  Woken woken = wait_.waitUntil(patience, [this] { return heard().has_value() || isOrphaned(); });
  const bool is_taken_up = heard().has_value();
  if (woken == Woken::Timeout && !attempt.end.isOver()) {
    return withdraw(attempt, {Kind::Failed, fmt::format("nobody takes up the dispatched action {}",
                                                        attempt.step.name)});
  }
  if (is_taken_up) attempt.progress(ActionFeedback::ACTION_ENABLED);
  const auto isDone = [this] { return heard() && isOver(heard()->status); };
  if (woken == Woken::Holds)
    woken = wait_.waitUntil(attempt.end, [&] { return isDone() || isOrphaned(); });
  if (woken == Woken::Holds && isDone()) return treat(attempt, *heard());
  if (woken == Woken::Holds) {
    return {Kind::Failed, fmt::format("the component of {} is gone: it hears {} no more",
                                      attempt.step.name, dispatches_.getTopic())};
  }
  return withdraw(attempt, {woken == Woken::Interrupt ? Kind::Interrupted : Kind::TimedOut, ""});
}

// One that knows to be cancelled says that it has failed; ROSPlan's fall silent.
StepEnd DispatchedSteps::withdraw(const StepTry& attempt, StepEnd end) {
  const bool was_taken_up = heard().has_value();
  cancel(attempt.step);
  if (!was_taken_up && end.kind == StepEnd::Kind::Interrupted) return end;
  const auto isDone = [this] { return heard() && isOver(heard()->status); };
  wait_.settleUntil(any_message::deadlineIn(attempt.options.cancel_timeout),
                    [&] { return isDone() || isOrphaned(); });
  // It may have been faster than the cancel, and must not be done once more.
  const auto last = heard();
  if (last && last->status == ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE) return {};
  if (!was_taken_up && last && !isOver(last->status) && !isOrphaned()) {
    end.reason = fmt::format("the component of {} took it up too late", attempt.step.name);
    end.is_over = false;
  }
  return end;
}

}  // namespace goal_alignment::execution
