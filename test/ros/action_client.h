// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

namespace goal_alignment::test {

/// Before the client, so that its node handle can have the queue.
class OwnCallbackQueue {
 protected:
  explicit OwnCallbackQueue(const ros::NodeHandle& node) : own_node_(node) {
    own_node_.setCallbackQueue(&queue_);
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle own_node_;
};

/// actionlib's client without its races: where a server is quick, what it says meets a goal handle
/// that sendGoal() has not finished, and the program crashes. Here one waits for the other.
template <typename Action>
class ActionClient : private OwnCallbackQueue, public actionlib::SimpleActionClient<Action> {
 public:
  ACTION_DEFINITION(Action);
  using Base = actionlib::SimpleActionClient<Action>;

  ActionClient(const ros::NodeHandle& node, const std::string& name)
      : OwnCallbackQueue(node), Base(own_node_, name, false), listener_([this] { listen(); }) {}
  ~ActionClient() {
    stop_ = true;
    listener_.join();
  }
  ActionClient(const ActionClient&) = delete;
  ActionClient& operator=(const ActionClient&) = delete;

  void sendGoal(const Goal& goal, typename Base::SimpleDoneCallback done = {},
                typename Base::SimpleActiveCallback active = {},
                typename Base::SimpleFeedbackCallback feedback = {}) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    Base::sendGoal(goal, done, active, feedback);
  }
  void cancelGoal() {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    Base::cancelGoal();
  }
  actionlib::SimpleClientGoalState getState() const {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return Base::getState();
  }
  ResultConstPtr getResult() const {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return Base::getResult();
  }

 private:
  void listen() {
    while (!stop_) {
      {
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
        queue_.callAvailable();
      }
      ros::WallDuration(0.001).sleep();
    }
  }

  mutable std::recursive_mutex mutex_;
  std::atomic<bool> stop_{false};
  std::thread listener_;
};

}  // namespace goal_alignment::test
