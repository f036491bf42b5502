// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/ActionFeedback.h"
#include "goal_alignment/ExecutePlanAction.h"
#include "program.h"
#include "scenario.h"

namespace goal_alignment::test {

using ExecuteClient = ActionClient<ExecutePlanAction>;

/// A plan of steps such as {"go", {{"to", "kitchen"}}}, with a plan_id of its own.
using Step = std::pair<std::string, std::vector<std::pair<std::string, std::string>>>;
Plan planOf(const std::vector<Step>& steps);

/// The steps that were carried out: "(go hall) (open door)".
std::string doneBy(const ExecutePlanResult& result);

/// What is wanted of a plan_executor named /plan_executor whose mapping is ours.
class PlanRuns {
 protected:
  explicit PlanRuns(ros::NodeHandle node)
      : dispatches_(node, "/action_dispatch"),
        feedback_(node, "/action_feedback"),
        execute_(node, "/execute_plan") {}

  /// From the next plan on.
  void setMapping(const std::string& yaml);
  void send(const Plan& plan);
  ExecutePlanResult awaitEnd();
  ExecutePlanResult run(const Plan& plan);
  bool dispatched(const Plan& plan, int step);

  TemporaryFolder folder_;
  Topic<ActionDispatch> dispatches_;
  Topic<ActionFeedback> feedback_;
  ExecuteClient execute_;
  int mappings_ = 0;
};

}  // namespace goal_alignment::test
