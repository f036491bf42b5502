// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "goal_alignment/AlignAction.h"
#include "goal_alignment/ros_interface/action_server.h"
#include "goal_alignment/ros_interface/alignment_runner.h"
#include "goal_alignment/ros_interface/goal_ticket.h"

namespace goal_alignment::ros_interface {

/// The action `~align`: takes goals and cancels from callback threads, gives one goal after the
/// other to the solver thread. A newer goal displaces the one under way and the one that waits.
class AlignServer {
 public:
  AlignServer(const ros::NodeHandle& private_node, AlignmentRunner& runner);
  ~AlignServer();
  AlignServer(const AlignServer&) = delete;
  AlignServer& operator=(const AlignServer&) = delete;

  /// Takes a goal that came another way than as an action; `origin` begins its id.
  void submit(const AlignGoal& goal, const std::string& origin);

  /// Somebody supposes something of the last session, which the solver thread answers when idle.
  void nudge();

  /// The node is about to end: cancels the goals there are and those to come, and returns when the
  /// solver thread has left its session. The destructor does it as well.
  void endGoals();

 private:
  using Ticket = std::shared_ptr<GoalTicket>;

  void takeGoal(GoalTicket::Handle handle);
  void cancelGoal(const GoalTicket::Handle& handle);
  void end(const Ticket& ticket, const std::string& reason);
  void work();

  AlignmentRunner& runner_;
  std::mutex mutex_;  // guards the five below
  std::condition_variable changed_;
  Ticket next_;
  Ticket current_;
  bool stop_ = false;
  unsigned submitted_ = 0;

  ActionServer<AlignAction> server_;
  std::thread solver_;
};

}  // namespace goal_alignment::ros_interface
