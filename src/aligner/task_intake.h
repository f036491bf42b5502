// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <functional>
#include <map>
#include <string>

#include "align_server.h"
#include "announcer.h"
#include "goal_alignment/AlignAction.h"
#include "goal_alignment/HumanTask.h"
#include "taken_tasks.h"
#include "task_repeats.h"

namespace goal_alignment::aligner {

/// Takes tasks from the topic `human_task`, each once: what is published over and over is one task,
/// and so is what a latched publisher shows to a node or a connection that is new.
class TaskIntake {
 public:
  /// The goal for a task that brings no models.
  using ToGoal = std::function<AlignGoal(const HumanTask&)>;

  /// `folder` is for files of this node.
  TaskIntake(ros::NodeHandle node, const std::string& folder, AlignServer& align,
             Announcer& announcer, ToGoal to_goal);

 private:
  using Event = ros::MessageEvent<HumanTask const>;

  void take(const Event& event);
  bool isShownAgain(const Event& event);
  bool beginsConnection(const Event& event);
  void leaveOut(const HumanTask& task, const std::string& why);

  AlignServer& align_;
  Announcer& announcer_;
  const ToGoal to_goal_;
  TaskRepeats repeats_;
  TakenTasks taken_;
  // The newest connection of each publisher, by what it said of itself.
  std::map<std::string, boost::shared_ptr<ros::M_string>> connections_;
  ros::Subscriber tasks_;
};

}  // namespace goal_alignment::aligner
