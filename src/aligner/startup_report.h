// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <string>
#include <vector>

#include "announcer.h"
#include "node_options.h"
#include "robot_facts.h"
#include "task_notes.h"
#include "tf_state_bridge.h"

namespace goal_alignment::aligner {

/// What the node does once when it starts: reports faulty parameters, though only the next goal
/// would be refused for them, restores the facts that were kept, and tells people of tasks that
/// ended with the run before.
class StartupReport {
 public:
  /// All outlive this.
  struct Dependencies {
    Announcer& announcer;
    RobotFacts& facts;
    TfStateBridge& tf;
    TaskNotes& task_notes;
  };

  StartupReport(const ros::NodeHandle& private_node, const Dependencies& parts);

 private:
  void restoreFacts(const NodeOptions& options);
  void reportLostTasks();
  void publishWhenHeard();

  const Dependencies parts_;
  std::vector<std::string> lines_;  // for people
  int periods_waited_ = 0;
  ros::WallTimer timer_;
};

}  // namespace goal_alignment::aligner
