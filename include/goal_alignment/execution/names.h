// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Names in the ROS graph that belong to the execution of plans; each stands here alone.
namespace goal_alignment::execution {

constexpr const char* kExecutePlanAction = "execute_plan";
constexpr const char* kActionDispatchTopic = "action_dispatch";
constexpr const char* kActionFeedbackTopic = "action_feedback";

/// ROSPlan's name of the dispatch that withdraws the one with the same ids.
constexpr const char* kCancelDispatch = "cancel_action";

}  // namespace goal_alignment::execution
