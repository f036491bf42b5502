// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/auto_execution.h"

#include <actionlib_msgs/GoalStatus.h>

#include <utility>

#include "goal_alignment/execution/aligner_link.h"
#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::execution {
namespace {

constexpr std::uint32_t kQueueSize = 100;

bool hasPlan(const AlignActionResult& result) {
  return result.status.status == actionlib_msgs::GoalStatus::SUCCEEDED &&
         result.result.outcome == AlignResult::SUCCESS && result.result.plan.plan_id > 0;
}

}  // namespace

AutoExecution::AutoExecution(ros::NodeHandle node, const std::string& aligner, Submit submit)
    : submit_(std::move(submit)),
      results_(node.subscribe(aligner + "/" + ros_common::kAlignAction + "/result", kQueueSize,
                              &AutoExecution::hear, this)) {}

void AutoExecution::hear(const AlignActionResult::ConstPtr& result) {
  const std::string& goal_id = result->status.goal_id.id;
  if (!hasPlan(*result) || AlignerLink::isOwnGoal(goal_id)) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!seen_.insert(goal_id).second) return;
  }
  submit_(result->result.plan);
}

}  // namespace goal_alignment::execution
