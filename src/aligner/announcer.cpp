// SPDX-License-Identifier: BSD-3-Clause
#include "announcer.h"

#include <ros/console.h>
#include <std_msgs/String.h>

#include <limits>
#include <utility>

#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/outside_text.h"
#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::size_t kLongestEvent = 4000;  // bytes

}  // namespace

Announcer::Announcer(ros::NodeHandle private_node)
    : states_(private_node.advertise<AlignmentState>(ros_common::kStateTopic,
                                                     ros_common::kStateQueueSize, true)),
      plans_(
          private_node.advertise<Plan>(ros_common::kPlanTopic, ros_common::kStateQueueSize, true)),
      // Not only the newest: who tells the dialogue needs them all.
      questions_(private_node.advertise<Question>(ros_common::kQuestionTopic,
                                                  ros_common::kEventQueueSize, true)),
      events_(private_node.advertise<std_msgs::String>(ros_common::kEventsTopic,
                                                       ros_common::kEventQueueSize)) {
  // roscpp counts from 0.
  state_.header.seq = question_.header.seq = std::numeric_limits<std::uint32_t>::max();
  publish(AlignmentState{});
  publishNoQuestion();
}

void Announcer::publish(AlignmentState state) {
  state.header.stamp = ros_common::stampNow();
  const std::lock_guard<std::mutex> lock(mutex_);
  // roscpp counts what it publishes, but not what a service hands out.
  state.header.seq = state_.header.seq + 1;
  state.waiting = std::move(state_.waiting);
  state_ = std::move(state);
  states_.publish(state_);
}

void Announcer::showWaiting(std::vector<WaitingTask> waiting) {
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.header.stamp = ros_common::stampNow();
  ++state_.header.seq;
  state_.waiting = std::move(waiting);
  states_.publish(state_);
}

void Announcer::publish(Plan plan) {
  plan.header.stamp = ros_common::stampNow();
  const std::lock_guard<std::mutex> lock(mutex_);
  plan_ = std::move(plan);
  plans_.publish(plan_);
}

Question Announcer::publish(Question question) {
  const std::lock_guard<std::mutex> lock(mutex_);
  question.header.stamp = ros_common::stampNow();
  question.header.seq = question_.header.seq + 1;
  question_ = std::move(question);
  questions_.publish(question_);
  return question_;
}

void Announcer::publishNoQuestion() {
  publish(Question{});
}

void Announcer::tell(const std::string& line) {
  ROS_INFO("%s", publishEvent(line).c_str());
}

void Announcer::warn(const std::string& line) {
  ROS_WARN("%s", publishEvent(line).c_str());
}

// What names from outside may hold: whatever a terminal takes for a command, and megabytes.
std::string Announcer::publishEvent(const std::string& line) {
  std_msgs::String message;
  message.data = ros_common::onOneLine(line, kLongestEvent);
  events_.publish(message);
  return message.data;
}

Question Announcer::question() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return question_;
}

Plan Announcer::plan() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return plan_;
}

AlignmentState Announcer::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

}  // namespace goal_alignment::aligner
