// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/plan_executor.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <utility>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/ActionFeedback.h"
#include "goal_alignment/execution/names.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_interface/package_files.h"
#include "goal_alignment/ros_interface/stamp.h"

namespace goal_alignment::execution {
namespace {

constexpr std::uint32_t kQueueSize = 100;

ExecutePlanResult resultWith(std::uint16_t outcome, std::string reason) {
  ExecutePlanResult result;
  result.outcome = outcome;
  result.failed_step = -1;
  result.reason = std::move(reason);
  return result;
}

ExecutePlanResult canceledBeforeItBegan() {
  return resultWith(ExecutePlanResult::CANCELED, "canceled before it began");
}

bool cancelRequested(const actionlib_msgs::GoalStatus& status) {
  return status.status == actionlib_msgs::GoalStatus::RECALLING ||
         status.status == actionlib_msgs::GoalStatus::PREEMPTING;
}

}  // namespace

PlanExecutor::PlanExecutor(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           std::optional<StepKind> default_kind)
    : private_node_(private_node),
      default_kind_(default_kind),
      dispatches_(
          ros::NodeHandle(node).advertise<ActionDispatch>(kActionDispatchTopic, kQueueSize)),
      feedback_(ros::NodeHandle(node).advertise<ActionFeedback>(kActionFeedbackTopic, kQueueSize)),
      services_(node, wait_),
      aligner_(node, ExecutorOptions::atTheStart(private_node).aligner, services_, wait_),
      action_steps_(node, wait_),
      service_steps_(services_),
      dispatched_steps_(node, dispatches_, wait_),
      simulated_steps_(node, wait_),
      server_(
          node, kExecutePlanAction, [this](Goal goal) { takeGoal(std::move(goal)); },
          [this](const Goal& goal) { cancelGoal(goal); }, canceledBeforeItBegan()) {
  complainAtTheStart();
  worker_ = std::thread([this] { work(); });
  server_.start();
}

PlanExecutor::~PlanExecutor() {
  endGoals();
}

// A fault is told at the start, though only the next plan would be refused for it; and the frames
// of a simulated world are there before a plan is.
void PlanExecutor::complainAtTheStart() {
  try {
    const ExecutorOptions options = ExecutorOptions::read(private_node_);
    warnAboutUnknown(options);
    simulated_steps_.begin(mappingOf(options), options);
  } catch (const std::exception& error) {
    ROS_ERROR("%s", error.what());
  }
}

void PlanExecutor::warnAboutUnknown(const ExecutorOptions& options) {
  for (const std::string& key : options.unknown) {
    if (!warned_about_.insert(key).second) continue;
    ROS_WARN("nobody reads the parameter %s", private_node_.resolveName(key).c_str());
  }
}

StepMapping PlanExecutor::mappingOf(const ExecutorOptions& options) {
  if (options.mapping.empty()) return StepMapping::fromYaml("", "", types_, default_kind_);
  const pddl::Source file = pddl::readFile(ros_interface::resolveFile(options.mapping));
  return StepMapping::fromYaml(file.text, file.name, types_, default_kind_);
}

void PlanExecutor::endGoals() {
  std::optional<Goal> next;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
    next = std::exchange(next_, std::nullopt);
    if (current_) interrupt("the node shuts down");
  }
  changed_.notify_all();
  if (next) conclude(*next, resultWith(ExecutePlanResult::CANCELED, "the node shuts down"));
  if (worker_.joinable()) worker_.join();
}

void PlanExecutor::interrupt(const std::string& why) {
  if (why_stopped_.empty()) why_stopped_ = why;
  wait_.interrupt();
}

void PlanExecutor::submit(const Plan& plan, const std::string& origin) {
  unsigned number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    number = ++submitted_;
  }
  ExecutePlanGoal goal;
  goal.plan = plan;
  // Unique among goals of this node, and those of an earlier run with the same name.
  server_.inject(goal, fmt::format("{}-{}-{}", origin, ros_interface::stampNow().toNSec(), number));
}

void PlanExecutor::takeGoal(Goal goal) {
  std::optional<Goal> ended;
  std::string why = "displaced by a newer plan";
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    // A cancel may have overtaken its goal between the server's list and this callback.
    if (stop_ || cancelRequested(goal.getGoalStatus())) {
      ended = goal;
      why = stop_ ? "the node shuts down" : "canceled before it began";
    } else {
      ended = std::exchange(next_, goal);
      if (current_) interrupt(why);
    }
  }
  changed_.notify_all();
  if (ended) conclude(*ended, resultWith(ExecutePlanResult::CANCELED, why));
}

void PlanExecutor::cancelGoal(const Goal& goal) {
  std::optional<Goal> recalled;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (next_ && *next_ == goal) {
      recalled = std::exchange(next_, std::nullopt);
    } else if (current_ && *current_ == goal) {
      interrupt("canceled");
    }
  }
  if (recalled) conclude(*recalled, canceledBeforeItBegan());
}

void PlanExecutor::work() {
  while (true) {
    Goal goal;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return stop_ || next_.has_value(); });
      if (stop_) return;
      goal = *next_;
      current_ = std::exchange(next_, std::nullopt);
      why_stopped_.clear();
      wait_.clear();
    }
    run(goal);
    const std::lock_guard<std::mutex> lock(mutex_);
    current_.reset();
  }
}

void PlanExecutor::run(Goal goal) {
  const Plan plan = goal.getGoal()->plan;
  ExecutorOptions options;
  StepMapping mapping;
  std::string fault = faultOf(plan);
  try {
    options = ExecutorOptions::read(private_node_);
    mapping = mappingOf(options);
  } catch (const std::exception& error) {  // of a parameter, a file, the mapping in it
    fault = error.what();
  }
  const RunParts parts{types_,   action_steps_, service_steps_, dispatched_steps_, simulated_steps_,
                       aligner_, wait_,         dispatches_,    feedback_};
  PlanRun run(parts, mapping, options,
              [&goal](const ExecutePlanFeedback& feedback) { goal.publishFeedback(feedback); });
  if (fault.empty()) fault = run.mappingFault(plan);
  if (!fault.empty()) {
    ROS_WARN("refused a plan: %s", fault.c_str());
    return conclude(goal, resultWith(ExecutePlanResult::INVALID_PLAN, fault));
  }
  warnAboutUnknown(options);
  goal.setAccepted();
  simulated_steps_.begin(mapping, options);
  conclude(goal, run.run(plan));
}

void PlanExecutor::conclude(Goal goal, ExecutePlanResult result) {
  if (result.outcome == ExecutePlanResult::CANCELED) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (current_ && *current_ == goal && !why_stopped_.empty())
        result.reason = why_stopped_ + ": " + result.reason;
    }
    return goal.setCanceled(result, result.reason);
  }
  if (result.outcome == ExecutePlanResult::SUCCESS) return goal.setSucceeded(result);
  if (result.outcome == ExecutePlanResult::INVALID_PLAN)
    return goal.setRejected(result, result.reason);
  goal.setAborted(result, result.reason);
}

}  // namespace goal_alignment::execution
