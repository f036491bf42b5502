// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "alignment_runner.h"
#include "announcer.h"
#include "goal_alignment/AlignAction.h"
#include "goal_alignment/ros_common/action_server.h"
#include "goal_ticket.h"
#include "plan_watch.h"
#include "task_queue.h"

namespace goal_alignment::aligner {

/// The action `~align`: takes goals and cancels from callback threads, gives one goal after the
/// other to the solver thread. A newer goal displaces the one under way. While a plan is being
/// carried out, a new task waits until that is over, or is refused; what continues a session never
/// waits.
class AlignServer {
 public:
  /// Tasks that come while a plan is carried out are refused. Asked on the thread of the goal.
  using RefusesIfBusy = std::function<bool()>;
  /// Takes the tasks that wait from now on.
  using NoteWaiting = std::function<void(const std::vector<WaitingTask>&)>;

  AlignServer(const ros::NodeHandle& private_node, AlignmentRunner& runner, Announcer& announcer,
              const PlanWatch& watch, RefusesIfBusy refuses_if_busy, NoteWaiting note_waiting);
  ~AlignServer();
  AlignServer(const AlignServer&) = delete;
  AlignServer& operator=(const AlignServer&) = delete;

  /// Takes a goal that came another way than as an action; `origin` begins its id.
  void submit(const AlignGoal& goal, const std::string& origin);

  /// An equal goal is being aligned, waits, or has its plan carried out.
  bool isUnderWay(const AlignGoal& goal) const;

  /// Somebody supposes something of the last session, which the solver thread answers when idle.
  void wakeUp();

  /// The watch knows more than before.
  void onExecutorStatus();

  /// The node is about to end: cancels the goals there are and those to come, and returns when the
  /// solver thread has left its session. The destructor does it as well.
  void endGoals();

 private:
  using Ticket = std::shared_ptr<GoalTicket>;
  using Queue = TaskQueue<Ticket>;

  void takeGoal(GoalTicket::Handle handle);
  void queueUp(const Ticket& ticket);
  void cancelGoal(const GoalTicket::Handle& handle);
  void end(const Ticket& ticket, const std::string& reason);
  void displace(const Ticket& ticket);
  void refuse(const Ticket& ticket, const std::string& reason);
  void work();
  void run(GoalTicket& ticket);

  // All need mutex_, which the first lets go of while it waits.
  Ticket awaitNext(std::unique_lock<std::mutex>& lock);
  Ticket takeNext();
  bool mustWait(const GoalTicket& ticket) const;
  void showQueue();

  AlignmentRunner& runner_;
  Announcer& announcer_;
  const PlanWatch& watch_;
  const RefusesIfBusy refuses_if_busy_;
  const NoteWaiting note_waiting_;
  mutable std::mutex mutex_;  // guards the six below
  std::condition_variable changed_;
  Ticket next_;
  Queue queue_;
  Ticket current_;
  bool stop_ = false;
  unsigned submitted_ = 0;

  ros_common::ActionServer<AlignAction> server_;
  std::thread solver_;
};

}  // namespace goal_alignment::aligner
