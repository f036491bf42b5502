// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <functional>
#include <mutex>
#include <set>
#include <string>

#include "goal_alignment/AlignActionResult.h"
#include "goal_alignment/Plan.h"

namespace goal_alignment::execution {

/// Has the plan of every alignment executed once. It listens to how the aligner's goals end, which
/// is told once and never latched, so that what it acts on has happened while it was there: a plan
/// of an earlier life, which `~plan` still shows, is never run. The executor's own goals, which ask
/// for a new plan, are left to the run that sent them.
class AutoExecution {
 public:
  using Submit = std::function<void(const Plan&)>;

  AutoExecution(ros::NodeHandle node, const std::string& aligner, Submit submit);

 private:
  void hear(const AlignActionResult::ConstPtr& result);

  Submit submit_;
  std::mutex mutex_;            // guards the one below
  std::set<std::string> seen_;  // ids of goals
  ros::Subscriber results_;
};

}  // namespace goal_alignment::execution
