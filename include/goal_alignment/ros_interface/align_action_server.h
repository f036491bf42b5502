// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/action_server.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>

#include <functional>
#include <string>

#include "goal_alignment/AlignAction.h"

namespace goal_alignment::ros_interface {

/// actionlib's server with two differences. actionlib itself ends a goal whose cancel came first,
/// with an empty result; here no result goes out without an outcome. And its status timer and list
/// run on a clock that may stand still; here on wall time.
class AlignActionServer : public actionlib::ActionServerBase<AlignAction> {
 public:
  using Base = actionlib::ActionServerBase<AlignAction>;
  using Callback = std::function<void(GoalHandle)>;

  AlignActionServer(const ros::NodeHandle& node, const std::string& name, Callback goal,
                    Callback cancel);

  /// Treats a goal of this program as if a client had sent it.
  void inject(const AlignGoal& goal, const std::string& goal_id);

 private:
  void initialize() override;
  void publishResult(const actionlib_msgs::GoalStatus& status, const AlignResult& result) override;
  void publishFeedback(const actionlib_msgs::GoalStatus& status,
                       const AlignFeedback& feedback) override;
  void publishStatus() override;
  void forgetOldGoals(const ros::Time& now);

  ros::NodeHandle node_;
  ros::Publisher results_;
  ros::Publisher feedback_;
  ros::Publisher status_;
  ros::Subscriber goals_;
  ros::Subscriber cancels_;
  ros::WallTimer status_timer_;
};

}  // namespace goal_alignment::ros_interface
