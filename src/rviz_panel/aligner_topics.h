// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <functional>
#include <string>

#include "goal_alignment/AlignActionGoal.h"
#include "goal_alignment/AlignActionResult.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/ExecutePlanActionFeedback.h"
#include "goal_alignment/ExecutePlanActionGoal.h"
#include "goal_alignment/ExecutePlanActionResult.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/Question.h"

namespace goal_alignment::rviz_panel {

/// What is heard of an aligner; called from a thread of AlignerTopics.
struct Listener {
  std::function<void(const AlignmentState::ConstPtr&)> state;
  std::function<void(const Question::ConstPtr&)> question;
  std::function<void(const Plan::ConstPtr&)> plan;
  std::function<void(const AlignActionGoal::ConstPtr&)> align_goal;
  std::function<void(const AlignActionResult::ConstPtr&)> align_result;
  std::function<void()> heartbeat;
  std::function<void(const ExecutePlanActionGoal::ConstPtr&)> execution_begun;
  std::function<void(const ExecutePlanActionFeedback::ConstPtr&)> execution_feedback;
  std::function<void(const ExecutePlanActionResult::ConstPtr&)> execution_ended;
};

/// The topics of one aligner and of the executor beside it, with a thread for their messages.
/// Construction and destruction talk to the master and may hang with it.
class AlignerTopics {
 public:
  /// `aligner`: the resolved name of the node. Throws std::runtime_error that names the topic
  /// where something else in this process listens to one of them as to another type.
  AlignerTopics(const std::string& aligner, Listener listener);
  ~AlignerTopics();
  AlignerTopics(const AlignerTopics&) = delete;
  AlignerTopics& operator=(const AlignerTopics&) = delete;

  // From any thread, at once. They return whether anybody listens.
  bool send(const AlignActionGoal& goal);
  bool send(const ExecutePlanActionGoal& goal);
  /// `goal_id` "": all goals.
  bool cancelAlignment(const std::string& goal_id = "");
  bool cancelExecution();

  /// Whether anybody publishes states, as far as the master has said.
  bool hasPublisher() const { return states_.getNumPublishers() > 0; }

 private:
  template <typename Message>
  ros::Subscriber listen(const std::string& topic,
                         const std::function<void(const boost::shared_ptr<const Message>&)>& hear);

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  Listener listener_;
  ros::Subscriber states_;
  ros::Subscriber questions_;
  ros::Subscriber plans_;
  ros::Subscriber tasks_;
  ros::Subscriber results_;
  ros::Subscriber statuses_;
  ros::Subscriber execution_goals_;
  ros::Subscriber execution_feedback_;
  ros::Subscriber execution_results_;
  ros::Publisher goals_;
  ros::Publisher plans_to_execute_;
  ros::Publisher align_cancels_;
  ros::Publisher execution_cancels_;
  ros::AsyncSpinner spinner_;
};

}  // namespace goal_alignment::rviz_panel
