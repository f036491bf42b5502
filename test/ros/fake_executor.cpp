// SPDX-License-Identifier: BSD-3-Clause
#include "fake_executor.h"

namespace goal_alignment::test {

FakeExecutor::FakeExecutor(ros::NodeHandle node)
    : status_(node.advertise<actionlib_msgs::GoalStatusArray>("/execute_plan/status", 100)),
      thread_([this] { talk(); }) {}

FakeExecutor::~FakeExecutor() {
  over_ = true;
  thread_.join();
}

void FakeExecutor::begin() {
  actionlib_msgs::GoalStatus goal;
  goal.goal_id.id = "plan-" + std::to_string(++begun_);
  goal.status = actionlib_msgs::GoalStatus::ACTIVE;
  const std::lock_guard<std::mutex> lock(mutex_);
  goals_.status_list.push_back(goal);
  status_.publish(goals_);
}

void FakeExecutor::finish() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto& goal : goals_.status_list)
    goal.status = actionlib_msgs::GoalStatus::SUCCEEDED;
  status_.publish(goals_);
}

void FakeExecutor::talk() {
  for (; !over_; ros::WallDuration(0.05).sleep()) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!silent_) status_.publish(goals_);
  }
}

}  // namespace goal_alignment::test
