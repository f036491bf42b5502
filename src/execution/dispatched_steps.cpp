// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
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

}  // namespace

DispatchedSteps::DispatchedSteps(ros::NodeHandle node, ros::Publisher dispatches, WaitPoint& wait)
    : dispatches_(std::move(dispatches)),
      wait_(wait),
      feedback_(node.subscribe(kActionFeedbackTopic, kQueueSize, &DispatchedSteps::hear, this)) {}

void DispatchedSteps::hear(const ros::MessageEvent<const ActionFeedback>& event) {
  // What this node says about a try that timed out is not about the next one.
  if (event.getPublisherName() == ros::this_node::getName()) return;
  const ActionFeedback& feedback = *event.getConstMessage();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (expected_ == nullptr || feedback.action_id != expected_->action_id) return;
    // ROSPlan's C++ base class of components leaves the plan's id out; ours count from 1.
    if (feedback.plan_id != expected_->plan_id && feedback.plan_id != 0) return;
    if (last_ && isOver(last_->status)) return;  // another component may still have its say
    last_ = feedback;
  }
  wait_.notify();
}

void DispatchedSteps::expect(const ActionDispatch* step) {
  const std::lock_guard<std::mutex> lock(mutex_);
  expected_ = step;
  last_.reset();
}

std::optional<ActionFeedback> DispatchedSteps::heard() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
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
    default:
      return {StepEnd::Kind::Failed, fmt::format("the component of {} says that it failed{}",
                                                 action, informationOf(feedback))};
  }
}

StepEnd DispatchedSteps::run(const StepTry& attempt) {
  using Woken = WaitPoint::Woken;
  const auto isListening = [this] { return dispatches_.getNumSubscribers() > 0; };
  const auto patience = std::min(deadlineIn(attempt.rule.server_patience), attempt.end);
  if (wait_.waitUntil(patience, isListening) == Woken::Interrupt)
    return {StepEnd::Kind::Interrupted, ""};
  expect(&attempt.step);
  const StepEnd end = await(attempt, patience);
  expect(nullptr);
  return end;
}

StepEnd DispatchedSteps::await(const StepTry& attempt, Clock::time_point patience) {
  using Woken = WaitPoint::Woken;
  attempt.dispatch();

  Woken woken = wait_.waitUntil(patience, [this] { return heard().has_value(); });
  if (woken == Woken::Timeout && patience < attempt.end) {
    cancel(attempt.step);
    return {StepEnd::Kind::Failed,
            fmt::format("nobody takes up the dispatched action {}", attempt.step.name)};
  }
  if (woken == Woken::Holds) {
    attempt.progress(ActionFeedback::ACTION_ENABLED);
    woken = wait_.waitUntil(attempt.end, [this] { return isOver(heard()->status); });
  }
  if (woken == Woken::Holds) return treat(attempt, *heard());
  cancel(attempt.step);
  // One that knows to be cancelled says that it has failed.
  wait_.settleUntil(deadlineIn(attempt.options.cancel_patience), [this] {
    const auto feedback = heard();
    return !feedback || isOver(feedback->status);
  });
  // It may have been faster than the cancel, and must not be done once more.
  const auto last = heard();
  if (last && last->status == ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE) return {};
  const bool interrupted = woken == Woken::Interrupt;
  return {interrupted ? StepEnd::Kind::Interrupted : StepEnd::Kind::TimedOut, ""};
}

}  // namespace goal_alignment::execution
