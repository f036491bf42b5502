// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/action_server.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::ros_common {

/// actionlib's server with two differences. actionlib itself ends a goal whose cancel came first,
/// with an empty result; here no result goes out without an outcome. And its status timer and list
/// run on a clock that may stand still; here on wall time. The action's result has an `outcome`.
template <class Action>
class ActionServer : public actionlib::ActionServerBase<Action> {
 public:
  ACTION_DEFINITION(Action);
  using Base = actionlib::ActionServerBase<Action>;
  using GoalHandle = typename Base::GoalHandle;
  using Callback = std::function<void(GoalHandle)>;

  /// `canceled` is the result of a goal whose cancel came before it.
  ActionServer(const ros::NodeHandle& node, const std::string& name, Callback goal, Callback cancel,
               Result canceled)
      : Base(std::move(goal), std::move(cancel)),
        node_(node, name),
        canceled_(std::move(canceled)) {}

  /// Treats a goal of this program as if a client had sent it.
  void inject(const Goal& goal, const std::string& goal_id) {
    const auto message = boost::make_shared<ActionGoal>();
    message->header.stamp = stampNow();
    message->goal_id.id = goal_id;
    message->goal_id.stamp = message->header.stamp;
    message->goal = goal;
    this->goalCallback(message);
  }

 private:
  static constexpr std::uint32_t kQueueSize = 1000;  // a goal that is dropped never ends
  static constexpr double kStatusPeriod = 0.2;       // seconds, as actionlib's
  static constexpr double kStatusKept = 5.0;         // seconds, as actionlib's

  void initialize() override {
    results_ = node_.template advertise<ActionResult>("result", kQueueSize);
    feedback_ = node_.template advertise<ActionFeedback>("feedback", kQueueSize);
    status_ = node_.template advertise<actionlib_msgs::GoalStatusArray>("status", kQueueSize, true);
    const boost::function<void(const ActionGoalConstPtr&)> take_goal =
        [this](const ActionGoalConstPtr& goal) { this->goalCallback(goal); };
    goals_ = node_.template subscribe<ActionGoal>("goal", kQueueSize, take_goal);
    const boost::function<void(const actionlib_msgs::GoalID::ConstPtr&)> take_cancel =
        [this](const actionlib_msgs::GoalID::ConstPtr& goal_id) { takeCancel(goal_id); };
    cancels_ = node_.template subscribe<actionlib_msgs::GoalID>("cancel", kQueueSize, take_cancel);
    status_timer_ =
        node_.createWallTimer(ros::WallDuration(kStatusPeriod), [this](const ros::WallTimerEvent&) {
          publishStatus();
          forgetOldGoals();
        });
  }

  void publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) override {
    ActionResult message;
    message.header.stamp = stampNow();
    message.status = status;
    // Empty where actionlib ended the goal before it reached us: a cancel that came first.
    message.result = result.outcome == Result::NONE ? canceled_ : result;
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    results_.publish(message);
    publishStatus();
  }

  void publishFeedback(const actionlib_msgs::GoalStatus& status,
                       const Feedback& feedback) override {
    ActionFeedback message;
    message.header.stamp = stampNow();
    message.status = status;
    message.feedback = feedback;
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    feedback_.publish(message);
  }

  void publishStatus() override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    actionlib_msgs::GoalStatusArray message;
    message.header.stamp = stampNow();
    for (const auto& tracker : this->status_list_)
      message.status_list.push_back(tracker.status_);
    status_.publish(message);
  }

  void takeCancel(const actionlib_msgs::GoalID::ConstPtr& goal_id) {
    this->cancelCallback(goal_id);
    // The stamp is of a clock that may be wrong. A cancel that came before its goal waits for it
    // from now on, and goals that nobody has thought of yet can't be meant.
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    const ros::Time now = stampNow();
    this->last_cancel_ = std::min(this->last_cancel_, now);
    for (auto& tracker : this->status_list_) {
      const bool waits = tracker.handle_tracker_.expired() &&
                         tracker.status_.status == actionlib_msgs::GoalStatus::RECALLING;
      if (waits && tracker.status_.goal_id.id == goal_id->id)
        tracker.handle_destruction_time_ = now;
    }
  }

  // Of the timer alone: actionlib publishes the status while it holds an entry of the list.
  void forgetOldGoals() {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    const ros::Time now = stampNow();
    auto& list = this->status_list_;
    for (auto tracker = list.begin(); tracker != list.end();) {
      const bool unused = tracker->handle_tracker_.expired();
      ros::Time& ended = tracker->handle_destruction_time_;
      // Zero while the simulated clock stood there; later than now what a client gave as the time
      // of a goal that it sent twice, or where a clock was set back.
      if (unused && (ended.isZero() || ended > now)) ended = now;
      // Not as a Duration, which does not hold every difference.
      const bool old = unused && now.toSec() - ended.toSec() > kStatusKept;
      tracker = old ? list.erase(tracker) : std::next(tracker);
    }
  }

  ros::NodeHandle node_;
  Result canceled_;
  ros::Publisher results_;
  ros::Publisher feedback_;
  ros::Publisher status_;
  ros::Subscriber goals_;
  ros::Subscriber cancels_;
  ros::WallTimer status_timer_;
};

}  // namespace goal_alignment::ros_common
