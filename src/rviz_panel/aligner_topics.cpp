// SPDX-License-Identifier: BSD-3-Clause
#include "aligner_topics.h"

#include <actionlib_msgs/GoalID.h>
#include <ros/exceptions.h>
#include <ros/names.h>

#include <stdexcept>
#include <utility>

#include "names.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr std::uint32_t kQueueSize = 100;

std::string below(const std::string& name, const std::string& action, const std::string& topic) {
  return ros::names::append(name, action + "/" + topic);
}

}  // namespace

template <typename Message>
ros::Subscriber AlignerTopics::listen(
    const std::string& topic,
    const std::function<void(const boost::shared_ptr<const Message>&)>& hear) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> callback = hear;
  try {
    return node_.subscribe<Message>(topic, kQueueSize, callback);
  } catch (const ros::Exception& error) {
    throw std::runtime_error("can't listen to " + topic + ": " + error.what());
  }
}

AlignerTopics::AlignerTopics(const std::string& aligner, Listener listener)
    : listener_(std::move(listener)), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  const std::string robot = ros::names::parentNamespace(aligner);
  states_ = listen<AlignmentState>(ros::names::append(aligner, kStateTopic), listener_.state);
  questions_ = listen<Question>(ros::names::append(aligner, kQuestionTopic), listener_.question);
  plans_ = listen<Plan>(ros::names::append(aligner, kPlanTopic), listener_.plan);
  tasks_ = listen<AlignActionGoal>(below(aligner, kAlignAction, "goal"), listener_.align_goal);
  results_ =
      listen<AlignActionResult>(below(aligner, kAlignAction, "result"), listener_.align_result);
  statuses_ = listen<actionlib_msgs::GoalStatusArray>(
      below(aligner, kAlignAction, "status"),
      [this](const actionlib_msgs::GoalStatusArray::ConstPtr& /*status*/) {
        listener_.heartbeat();
      });
  execution_goals_ = listen<ExecutePlanActionGoal>(below(robot, kExecutePlanAction, "goal"),
                                                   listener_.execution_begun);
  execution_feedback_ = listen<ExecutePlanActionFeedback>(
      below(robot, kExecutePlanAction, "feedback"), listener_.execution_feedback);
  execution_results_ = listen<ExecutePlanActionResult>(below(robot, kExecutePlanAction, "result"),
                                                       listener_.execution_ended);
  goals_ = node_.advertise<AlignActionGoal>(below(aligner, kAlignAction, "goal"), kQueueSize);
  plans_to_execute_ =
      node_.advertise<ExecutePlanActionGoal>(below(robot, kExecutePlanAction, "goal"), kQueueSize);
  align_cancels_ =
      node_.advertise<actionlib_msgs::GoalID>(below(aligner, kAlignAction, "cancel"), kQueueSize);
  execution_cancels_ = node_.advertise<actionlib_msgs::GoalID>(
      below(robot, kExecutePlanAction, "cancel"), kQueueSize);
  spinner_.start();
}

AlignerTopics::~AlignerTopics() {
  spinner_.stop();
}

// This process listens to goals as well, so that one subscriber is none.
bool AlignerTopics::send(const AlignActionGoal& goal) {
  if (results_.getNumPublishers() == 0 || goals_.getNumSubscribers() < 2) return false;
  goals_.publish(goal);
  return true;
}

bool AlignerTopics::send(const ExecutePlanActionGoal& goal) {
  if (execution_results_.getNumPublishers() == 0 || plans_to_execute_.getNumSubscribers() < 2)
    return false;
  plans_to_execute_.publish(goal);
  return true;
}

// An empty id with a zero time stamp is actionlib's way to say "all goals", whoever sent them.
bool AlignerTopics::cancelAlignment(const std::string& goal_id) {
  if (align_cancels_.getNumSubscribers() == 0) return false;
  actionlib_msgs::GoalID goal;
  goal.id = goal_id;
  align_cancels_.publish(goal);
  return true;
}

bool AlignerTopics::cancelExecution() {
  if (execution_cancels_.getNumSubscribers() == 0) return false;
  execution_cancels_.publish(actionlib_msgs::GoalID());
  return true;
}

}  // namespace goal_alignment::rviz_panel
