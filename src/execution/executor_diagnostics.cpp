// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/executor_diagnostics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "goal_alignment/ExecutePlanResult.h"

namespace goal_alignment::execution {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

ExecutorDiagnostics::ExecutorDiagnostics(ros::NodeHandle node, const ros::NodeHandle& private_node)
    : updater_(node, private_node) {
  updater_.setHardwareID("none");
  updater_.add("execution", this, &ExecutorDiagnostics::report);
  // Forced, since the updater's own period is one of ROS time, which may stand still.
  timer_ = node.createWallTimer(ros::WallDuration(updater_.getPeriod()),
                                [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void ExecutorDiagnostics::begin(int plan_id, std::size_t steps) {
  const std::lock_guard<std::mutex> lock(mutex_);
  plan_id_ = plan_id;
  steps_ = steps;
  step_ = "none";
  missing_.clear();
}

void ExecutorDiagnostics::follow(int step, const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  step_ = fmt::format("{} of {}: {}", step, steps_, text);
}

void ExecutorDiagnostics::end(std::uint16_t outcome, const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  plan_id_ = 0;
  outcome_ = outcome;
  outcome_text_ = outcome == ExecutePlanResult::SUCCESS ? fmt::format("success ({})", outcome)
                                                        : fmt::format("{}: {}", outcome, reason);
}

void ExecutorDiagnostics::setMissing(const std::set<std::string>& servers) {
  const std::lock_guard<std::mutex> lock(mutex_);
  missing_ = servers;
}

void ExecutorDiagnostics::report(DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool runs = plan_id_ != 0;
  status.summary(DiagnosticStatus::OK, runs ? "executing a plan" : "idle");
  status.add("plan", runs ? std::to_string(plan_id_) : "none");
  status.add("step", runs ? step_ : "none");
  status.add("last outcome", outcome_text_);
  status.add("servers missing",
             missing_.empty() ? "none" : fmt::format("{}", fmt::join(missing_, "; ")));
  const bool is_well = outcome_ == ExecutePlanResult::NONE ||
                       outcome_ == ExecutePlanResult::SUCCESS ||
                       outcome_ == ExecutePlanResult::CANCELED;
  if (!runs && !is_well) status.mergeSummary(DiagnosticStatus::WARN, "the last plan failed");
  if (outcome_ == ExecutePlanResult::INTERNAL)
    status.mergeSummary(DiagnosticStatus::ERROR, "the last plan broke off");
  if (!missing_.empty()) status.mergeSummary(DiagnosticStatus::WARN, "servers are missing");
}

}  // namespace goal_alignment::execution
