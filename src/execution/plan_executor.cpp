// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/plan_executor.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <utility>

#include "goal_alignment/ActionFeedback.h"
#include "goal_alignment/execution/graph_view.h"
#include "goal_alignment/execution/mapping_check.h"
#include "goal_alignment/execution/names.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/package_files.h"
#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::execution {
namespace {

constexpr std::uint32_t kQueueSize = 100;
constexpr std::chrono::seconds kIdlePeriod{1};

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
      dispatches_(listeners_.advertise(node)),
      feedback_(ros::NodeHandle(node).advertise<ActionFeedback>(kActionFeedbackTopic, kQueueSize)),
      services_(node, wait_),
      aligner_(node, ExecutorOptions::atTheStart(private_node).aligner, services_, wait_),
      action_steps_(node, wait_),
      service_steps_(services_),
      dispatched_steps_(node, dispatches_, listeners_, wait_),
      simulated_steps_(node, wait_),
      diagnostics_(node, private_node),
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
    first_mapping_ = mappingOf(options);
    simulated_steps_.begin(first_mapping_, options);
    warnAboutMisfits(options);
    look_for_servers_ = any_message::deadlineIn(options.servers_timeout);
  } catch (const std::exception& error) {
    ROS_ERROR("%s", error.what());
  }
}

void PlanExecutor::warnOnce(const std::string& what) {
  if (warned_about_.insert(what).second) ROS_WARN("%s", what.c_str());
}

void PlanExecutor::warnAboutUnknown(const ExecutorOptions& options) {
  for (const std::string& warning : options.warnings)
    warnOnce(warning);
}

// The aligner complains where the model is faulty; and a robot may have none before its first task.
void PlanExecutor::warnAboutMisfits(const ExecutorOptions& options) {
  const auto source = [this](const std::string& given, const char* key) {
    return pddl::readFile(ros_common::resolveFile(given.empty() ? aligner_.parameter(key) : given));
  };
  try {
    const auto robot = pddl::readModel(source(options.robot_domain, "robot_domain"),
                                       source(options.robot_problem, "robot_problem"));
    for (const std::string& misfit : misfits(first_mapping_, robot))
      warnOnce(misfit);
  } catch (const std::exception& error) {
    ROS_DEBUG("the mapping is not held against the robot's model: %s", error.what());
  }
}

// By what the master knows: links are made when a plan wants them. Servers whose names hang on a
// step's arguments are looked for then, too.
void PlanExecutor::warnAboutServers() {
  look_for_servers_ = any_message::Clock::time_point::max();
  const auto graph = GraphView::now();
  std::set<std::string> missing;
  const YamlReader reader(first_mapping_.source);
  for (const auto& entry : first_mapping_.rules) {
    const StepRule& rule = entry.second;
    if (!graph || !rule.name.IsScalar() ||
        rule.name.Scalar().find_first_of("{}") != std::string::npos)
      continue;
    const std::string lack = graph->lackOf(rule, services_.resolved(rule.name.Scalar()));
    if (!lack.empty()) missing.insert(reader.place(rule.name.Mark()) + ": so far " + lack);
  }
  for (const std::string& lack : missing)
    warnOnce(lack);
  diagnostics_.setMissing(missing);
  first_mapping_ = {};
}

StepMapping PlanExecutor::mappingOf(const ExecutorOptions& options) {
  if (options.mapping.empty()) return StepMapping::fromYaml("", "", types_, default_kind_);
  const pddl::Source file = pddl::readFile(ros_common::resolveFile(options.mapping));
  StepMapping mapping = StepMapping::fromYaml(file.text, file.name, types_, default_kind_);
  for (const std::string& warning : mapping.warnings)
    warnOnce(warning);
  return mapping;
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
  server_.inject(goal, fmt::format("{}-{}-{}", origin, ros_common::stampNow().toNSec(), number));
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
      if (!changed_.wait_for(lock, kIdlePeriod, [this] { return stop_ || next_.has_value(); })) {
        lock.unlock();
        beIdle();
        continue;
      }
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

// What is told to the aligner between two plans must not keep the next one waiting.
void PlanExecutor::beIdle() {
  wait_.interrupt();
  if (ledger_.waits()) ledger_.tell();
  if (any_message::Clock::now() >= look_for_servers_) warnAboutServers();
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
  if (fault.empty()) fault = mappingFault(plan, mapping, types_);
  if (!fault.empty()) {
    diagnostics_.end(ExecutePlanResult::INVALID_PLAN, fault);
    return conclude(goal, resultWith(ExecutePlanResult::INVALID_PLAN, fault));
  }
  const RunParts parts{
      types_,
      action_steps_,
      service_steps_,
      dispatched_steps_,
      simulated_steps_,
      aligner_,
      ledger_,
      wait_,
      dispatches_,
      feedback_,
      [this](const std::string& misfit) { warnOnce(misfit); },
      [this](const std::set<std::string>& servers) { diagnostics_.setMissing(servers); }};
  PlanRun run(parts, mapping, options, [&](const ExecutePlanFeedback& feedback) {
    goal.publishFeedback(feedback);
    follow(run.plan(), feedback);
  });
  warnAboutUnknown(options);
  diagnostics_.begin(plan.plan_id, plan.steps.size());
  goal.setAccepted();
  simulated_steps_.begin(mapping, options);
  const ExecutePlanResult result = run.run(plan);
  diagnostics_.end(result.outcome, result.reason);
  conclude(goal, result);
}

void PlanExecutor::follow(const Plan& plan, const ExecutePlanFeedback& feedback) {
  if (feedback.new_plan.plan_id > 0)
    return diagnostics_.begin(feedback.new_plan.plan_id, feedback.new_plan.steps.size());
  const auto step = static_cast<std::size_t>(feedback.step);
  if (feedback.status == ActionFeedback::ACTION_ENABLED && step < plan.steps.size())
    diagnostics_.follow(feedback.step, textOf(plan.steps[step]));
}

// Whoever follows the log alone learns how each plan has ended.
void PlanExecutor::log(const ExecutePlanResult& result) {
  const std::string reason = result.reason;
  switch (result.outcome) {
    case ExecutePlanResult::SUCCESS:
      ROS_INFO("a plan was carried out: %zu steps, %u new plans on the way", result.done.size(),
               result.replans);
      break;
    case ExecutePlanResult::CANCELED:
      ROS_INFO("a plan ended early: %s", reason.c_str());
      break;
    case ExecutePlanResult::INVALID_PLAN:
      ROS_ERROR("refused a plan: %s", reason.c_str());
      break;
    default:
      ROS_ERROR("a plan failed (%d): %s", static_cast<int>(result.outcome), reason.c_str());
  }
}

void PlanExecutor::conclude(Goal goal, ExecutePlanResult result) {
  if (result.outcome == ExecutePlanResult::CANCELED) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (current_ && *current_ == goal && !why_stopped_.empty())
        result.reason = why_stopped_ + ": " + result.reason;
    }
  }
  log(result);
  if (result.outcome == ExecutePlanResult::CANCELED) return goal.setCanceled(result, result.reason);
  if (result.outcome == ExecutePlanResult::SUCCESS) return goal.setSucceeded(result);
  if (result.outcome == ExecutePlanResult::INVALID_PLAN)
    return goal.setRejected(result, result.reason);
  goal.setAborted(result, result.reason);
}

}  // namespace goal_alignment::execution
