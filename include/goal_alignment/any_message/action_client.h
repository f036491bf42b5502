// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>
#include <topic_tools/shape_shifter.h>

#include <mutex>
#include <optional>
#include <string>

#include "goal_alignment/any_message/message_codec.h"
#include "goal_alignment/any_message/wait_point.h"

namespace goal_alignment::any_message {

/// An actionlib client for servers of any type, one goal after the other. actionlib's own is a
/// template of the action, waits on a clock that may stand still, and does not see its server die.
class ActionClient {
 public:
  struct End {
    enum class Kind {
      Ended,        ///< `status`, `text` and, if it was heard, `result` say how
      NoServer,     ///< nobody offers the action
      Lost,         ///< the server went away, or forgot the goal
      TimedOut,     ///< the goal is cancelled, and had not succeeded before
      Interrupted,  ///< the same
    };
    Kind kind = Kind::Ended;
    std::uint8_t status = 0;  ///< of actionlib_msgs/GoalStatus
    std::string text;
    std::optional<Bytes> result;
    bool is_over = true;  ///< false: it was cancelled, and its server is still at it
  };

  /// How long things may take, in seconds, and the end of the whole.
  struct Limits {
    double patience = 0;        ///< until the server is there, or is lost; at least 0.5
    double cancel_timeout = 0;  ///< until a cancelled goal has ended
    TimeLimit end;
  };

  /// What is published on an action's topic `goal`.
  struct GoalType {
    std::string name;  ///< `package/NameActionGoal`
    std::string md5;
    std::string text;  ///< the definition, for who records the topic
  };

  ActionClient(const ros::NodeHandle& node, const std::string& name, GoalType type,
               WaitPoint& wait);

  /// Sends the goal, stamped `now`, under a new id, or `goal_id`, and returns when it has ended; a
  /// time-out or an interrupt cancels it, and waits until it has ended, but not for ever.
  End run(const Bytes& goal, const ros::Time& now, const Limits& limits,
          const std::string& goal_id = "");

  bool connected() const;
  const GoalType& type() const { return type_; }

 private:
  void hearStatus(const actionlib_msgs::GoalStatusArray::ConstPtr& statuses);
  void hearResult(const topic_tools::ShapeShifter::ConstPtr& result);
  void send(const Bytes& goal, const ros::Time& now, const std::string& goal_id);
  void cancel();
  bool hasEnded();
  bool isLost(double patience);
  End ending() const;

  std::string name_;
  GoalType type_;
  WaitPoint& wait_;

  mutable std::mutex mutex_;  // guards all below
  actionlib_msgs::GoalID id_;
  bool status_heard_ = false;
  std::optional<actionlib_msgs::GoalStatus> status_;  // of the goal
  std::optional<actionlib_msgs::GoalStatus> result_status_;
  Bytes result_;
  Clock::time_point last_sign_;    // of the goal
  Clock::time_point terminal_at_;  // when the status first said so; the result may be late
  bool missing_ = false;           // from the newest status list

  ros::Publisher goals_;
  ros::Publisher cancels_;
  ros::Subscriber results_;
  ros::Subscriber statuses_;
};

}  // namespace goal_alignment::any_message
