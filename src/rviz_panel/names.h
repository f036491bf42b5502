// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Names in the ROS graph that the panel speaks to. What is private to the aligner stands below its
/// name, what belongs to the execution of plans in the same namespace as the aligner.
namespace goal_alignment::rviz_panel {

constexpr const char* kDefaultAligner = "goal_alignment";
constexpr const char* kDefaultAnsweredBy = "panel";

constexpr const char* kQuestionTopic = "question";
constexpr const char* kStateTopic = "state";
constexpr const char* kPlanTopic = "plan";
constexpr const char* kAlignAction = "align";
constexpr const char* kExecutePlanAction = "execute_plan";
constexpr const char* kAnswerService = "answer";
constexpr const char* kReviseAnswerService = "revise_answer";

/// What `answered_by` says of candidates that nobody is asked about.
constexpr const char* kAssumed = "assumed";

}  // namespace goal_alignment::rviz_panel
