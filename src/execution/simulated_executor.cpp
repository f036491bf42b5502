// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/simulated_executor.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/ActionFeedback.h"
#include "goal_alignment/execution/names.h"

namespace goal_alignment::execution {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongestStep = 3600;  // seconds
constexpr std::uint32_t kQueueSize = 100;

ExecutePlanResult resultWith(std::uint16_t outcome, int failed_step, std::string reason) {
  ExecutePlanResult result;
  result.outcome = outcome;
  result.failed_step = failed_step;
  result.reason = std::move(reason);
  return result;
}

std::string textOf(const ActionDispatch& step) {
  std::string text = "(" + step.name;
  for (const auto& parameter : step.parameters)
    text += " " + parameter.value;
  return text + ")";
}

bool cancelRequested(const actionlib_msgs::GoalStatus& status) {
  return status.status == actionlib_msgs::GoalStatus::RECALLING ||
         status.status == actionlib_msgs::GoalStatus::PREEMPTING;
}

}  // namespace

SimulationOptions SimulationOptions::read(const ros::NodeHandle& private_node) {
  SimulationOptions options;
  const auto refuse = [&](const char* key, const std::string& expected) {
    throw std::invalid_argument(
        fmt::format("parameter {}/{}: expected {}", private_node.getNamespace(), key, expected));
  };
  if (private_node.hasParam(kStepDurationParameter) &&
      (!private_node.getParam(kStepDurationParameter, options.step_duration) ||
       !(options.step_duration >= 0 && options.step_duration <= kLongestStep))) {
    refuse(kStepDurationParameter, fmt::format("seconds from 0 to {:.0f}", kLongestStep));
  }
  if (private_node.hasParam(kFailingStepParameter) &&
      (!private_node.getParam(kFailingStepParameter, options.failing_step) ||
       options.failing_step < -1)) {
    refuse(kFailingStepParameter, "the index of a step, or -1 for none");
  }
  return options;
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
  return {};
}

SimulatedExecutor::SimulatedExecutor(ros::NodeHandle node, ros::NodeHandle private_node)
    : private_node_(std::move(private_node)),
      dispatches_(node.advertise<ActionDispatch>(kActionDispatchTopic, kQueueSize)),
      feedback_(node.advertise<ActionFeedback>(kActionFeedbackTopic, kQueueSize)),
      server_(
          node, kExecutePlanAction, [this](Goal goal) { takeGoal(std::move(goal)); },
          [this](Goal goal) { cancelGoal(std::move(goal)); }, false),
      worker_([this] { work(); }) {
  server_.start();
}

SimulatedExecutor::~SimulatedExecutor() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  worker_.join();
}

void SimulatedExecutor::takeGoal(Goal goal) {
  std::optional<Goal> displaced;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    // A cancel may have overtaken its goal between the server's list and this callback.
    if (cancelRequested(goal.getGoalStatus())) {
      displaced = goal;
    } else {
      displaced = std::exchange(next_, goal);
      interrupt_ = current_.has_value();
    }
  }
  changed_.notify_all();
  if (displaced) {
    displaced->setCanceled(resultWith(ExecutePlanResult::CANCELED, -1, "canceled before it began"));
  }
}

void SimulatedExecutor::cancelGoal(Goal goal) {
  bool recalled = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (next_ && *next_ == goal) {
      next_.reset();
      recalled = true;
    } else if (current_ && *current_ == goal) {
      interrupt_ = true;
    }
  }
  changed_.notify_all();
  if (recalled) {
    goal.setCanceled(resultWith(ExecutePlanResult::CANCELED, -1, "canceled before it began"));
  }
}

void SimulatedExecutor::work() {
  while (true) {
    Goal goal;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return stop_ || next_.has_value(); });
      if (stop_) return;
      goal = *next_;
      current_ = std::exchange(next_, std::nullopt);
      interrupt_ = false;
    }
    run(goal);
    const std::lock_guard<std::mutex> lock(mutex_);
    current_.reset();
  }
}

void SimulatedExecutor::run(Goal goal) {
  SimulationOptions options;
  std::string fault = faultOf(goal.getGoal()->plan);
  try {
    options = SimulationOptions::read(private_node_);
  } catch (const std::invalid_argument& error) {
    fault = error.what();
  }
  if (!fault.empty()) {
    ROS_WARN("refused a plan: %s", fault.c_str());
    goal.setRejected(resultWith(ExecutePlanResult::INVALID_PLAN, -1, fault), fault);
    return;
  }
  goal.setAccepted();
  const ExecutePlanResult result = walk(goal, options);
  if (result.outcome == ExecutePlanResult::SUCCESS) {
    goal.setSucceeded(result);
  } else if (result.outcome == ExecutePlanResult::CANCELED) {
    goal.setCanceled(result, result.reason);
  } else {
    goal.setAborted(result, result.reason);
  }
}

ExecutePlanResult SimulatedExecutor::walk(Goal& goal, const SimulationOptions& options) {
  const auto start = Clock::now();
  const auto shared_goal = goal.getGoal();
  for (const ActionDispatch& step : shared_goal->plan.steps) {
    const std::chrono::duration<float> since_start = Clock::now() - start;
    dispatch(step, since_start.count(), static_cast<float>(options.step_duration));
    report(goal, step, ActionFeedback::ACTION_ENABLED);
    if (interruptedWithin(options.step_duration)) {
      report(goal, step, ActionFeedback::ACTION_FAILED);
      return resultWith(ExecutePlanResult::CANCELED, step.action_id,
                        fmt::format("stopped during step {} {}", step.action_id, textOf(step)));
    }
    if (step.action_id == options.failing_step) {
      report(goal, step, ActionFeedback::ACTION_FAILED);
      return resultWith(ExecutePlanResult::STEP_FAILED, step.action_id,
                        fmt::format("step {} {} failed", step.action_id, textOf(step)));
    }
    report(goal, step, ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE);
  }
  return resultWith(ExecutePlanResult::SUCCESS, -1, "");
}

void SimulatedExecutor::dispatch(const ActionDispatch& step, float seconds_since_start,
                                 float duration) {
  ActionDispatch message = step;
  message.dispatch_time = seconds_since_start;
  message.duration = duration;
  dispatches_.publish(message);
}

void SimulatedExecutor::report(Goal& goal, const ActionDispatch& step, int status) {
  ActionFeedback message;
  message.action_id = step.action_id;
  message.plan_id = step.plan_id;
  message.status = status;
  feedback_.publish(message);

  ExecutePlanFeedback progress;
  progress.step = step.action_id;
  progress.status = static_cast<std::uint8_t>(status);
  goal.publishFeedback(progress);
}

// Wall time, since a simulated clock that stands still must not stop a cancel.
bool SimulatedExecutor::interruptedWithin(double seconds) {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                           [this] { return stop_ || interrupt_; });
}

}  // namespace goal_alignment::execution
