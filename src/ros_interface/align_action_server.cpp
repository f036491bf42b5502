// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/align_action_server.h"

#include <utility>

#include "goal_alignment/ros_interface/stamp.h"

namespace goal_alignment::ros_interface {
namespace {

constexpr std::uint32_t kQueueSize = 1000;  // a goal that is dropped never ends for its client
constexpr double kStatusPeriod = 0.2;       // seconds, as actionlib's
constexpr double kStatusKept = 5.0;         // seconds, as actionlib's

}  // namespace

AlignActionServer::AlignActionServer(const ros::NodeHandle& node, const std::string& name,
                                     Callback goal, Callback cancel)
    : Base(std::move(goal), std::move(cancel)), node_(node, name) {}

void AlignActionServer::initialize() {
  status_list_timeout_ = ros::Duration(kStatusKept);
  results_ = node_.advertise<AlignActionResult>("result", kQueueSize);
  feedback_ = node_.advertise<AlignActionFeedback>("feedback", kQueueSize);
  status_ = node_.advertise<actionlib_msgs::GoalStatusArray>("status", kQueueSize, true);
  goals_ = node_.subscribe<AlignActionGoal>(
      "goal", kQueueSize, [this](const AlignActionGoal::ConstPtr& goal) { goalCallback(goal); });
  cancels_ = node_.subscribe<actionlib_msgs::GoalID>(
      "cancel", kQueueSize,
      [this](const actionlib_msgs::GoalID::ConstPtr& goal_id) { cancelCallback(goal_id); });
  status_timer_ = node_.createWallTimer(ros::WallDuration(kStatusPeriod),
                                        [this](const ros::WallTimerEvent&) { publishStatus(); });
}

void AlignActionServer::inject(const AlignGoal& goal, const std::string& goal_id) {
  const auto message = boost::make_shared<AlignActionGoal>();
  message->header.stamp = stampNow();
  message->goal_id.id = goal_id;
  message->goal_id.stamp = message->header.stamp;
  message->goal = goal;
  goalCallback(message);
}

void AlignActionServer::publishResult(const actionlib_msgs::GoalStatus& status,
                                      const AlignResult& result) {
  AlignActionResult message;
  message.header.stamp = stampNow();
  message.status = status;
  message.result = result;
  // Empty where actionlib ended the goal before it reached us: a cancel that came first.
  if (result.outcome == AlignResult::NONE) {
    message.result.outcome = AlignResult::CANCELED;
    message.result.message = "canceled before it began";
    message.result.failing_step = -1;
  }
  const boost::recursive_mutex::scoped_lock lock(lock_);
  results_.publish(message);
  publishStatus();
}

void AlignActionServer::publishFeedback(const actionlib_msgs::GoalStatus& status,
                                        const AlignFeedback& feedback) {
  AlignActionFeedback message;
  message.header.stamp = stampNow();
  message.status = status;
  message.feedback = feedback;
  const boost::recursive_mutex::scoped_lock lock(lock_);
  feedback_.publish(message);
}

void AlignActionServer::publishStatus() {
  const boost::recursive_mutex::scoped_lock lock(lock_);
  actionlib_msgs::GoalStatusArray message;
  message.header.stamp = stampNow();
  for (const auto& tracker : status_list_)
    message.status_list.push_back(tracker.status_);
  forgetOldGoals(message.header.stamp);
  status_.publish(message);
}

void AlignActionServer::forgetOldGoals(const ros::Time& now) {
  for (auto tracker = status_list_.begin(); tracker != status_list_.end();) {
    // A cancel for a goal that never came, or an end while the simulated clock stood at zero.
    const bool unused = tracker->handle_tracker_.expired();
    if (unused && tracker->handle_destruction_time_.isZero()) {
      tracker->handle_destruction_time_ = now;
    }
    const ros::Time ended = tracker->handle_destruction_time_;
    const bool old = unused && !ended.isZero() && ended + status_list_timeout_ < now;
    tracker = old ? status_list_.erase(tracker) : std::next(tracker);
  }
}

}  // namespace goal_alignment::ros_interface
