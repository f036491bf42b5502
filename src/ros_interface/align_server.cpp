// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/align_server.h"

#include <fmt/format.h>

#include <utility>

#include "goal_alignment/ros_interface/node_constants.h"
#include "goal_alignment/ros_interface/stamp.h"

namespace goal_alignment::ros_interface {
namespace {

AlignResult canceledBeforeItBegan() {
  AlignResult result;
  result.outcome = AlignResult::CANCELED;
  result.message = "canceled before it began";
  result.failing_step = -1;
  return result;
}

}  // namespace

AlignServer::AlignServer(const ros::NodeHandle& private_node, AlignmentRunner& runner)
    : runner_(runner),
      server_(
          private_node, kAlignAction,
          [this](GoalTicket::Handle handle) { takeGoal(std::move(handle)); },
          [this](const GoalTicket::Handle& handle) { cancelGoal(handle); },
          canceledBeforeItBegan()),
      solver_([this] { work(); }) {
  server_.start();
}

AlignServer::~AlignServer() {
  endGoals();
}

void AlignServer::endGoals() {
  Ticket next;
  Ticket current;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
    next = std::exchange(next_, nullptr);
    current = current_;
  }
  changed_.notify_all();
  if (next) end(next, "the node shuts down");
  if (current) end(current, "the node shuts down");
  if (solver_.joinable()) solver_.join();
}

void AlignServer::nudge() {
  { const std::lock_guard<std::mutex> lock(mutex_); }  // so that no wait begins in between
  changed_.notify_all();
}

void AlignServer::submit(const AlignGoal& goal, const std::string& origin) {
  unsigned number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    number = ++submitted_;
  }
  // Unique among goals of this node, and those of an earlier run with the same name.
  server_.inject(goal, fmt::format("{}-{}-{}", origin, stampNow().toNSec(), number));
}

void AlignServer::takeGoal(GoalTicket::Handle handle) {
  const auto ticket = std::make_shared<GoalTicket>(std::move(handle));
  Ticket waiting;
  Ticket running;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stop_ || ticket->cancelOvertookIt()) {
      waiting = ticket;
    } else {
      waiting = std::exchange(next_, ticket);
      running = current_;
    }
  }
  changed_.notify_all();
  if (waiting) end(waiting, waiting == ticket ? "canceled" : "displaced by a newer goal");
  if (running) end(running, "displaced by a newer goal");
}

void AlignServer::cancelGoal(const GoalTicket::Handle& handle) {
  Ticket ticket;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (next_ && next_->isFor(handle)) {
      ticket = std::exchange(next_, nullptr);
    } else if (current_ && current_->isFor(handle)) {
      ticket = current_;
    }
  }
  if (ticket) end(ticket, "canceled");
}

// At once and from this thread: a cancel must not wait for the solver to notice it.
void AlignServer::end(const Ticket& ticket, const std::string& reason) {
  if (!runner_.stop(*ticket)) return;
  AlignResult result = ticket->interim();
  result.outcome = AlignResult::CANCELED;
  result.message = reason;
  ticket->conclude(result);
}

void AlignServer::work() {
  while (true) {
    Ticket ticket;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return stop_ || next_ || runner_.isAskedToSuppose(); });
      if (stop_) return;
      ticket = current_ = std::exchange(next_, nullptr);
    }
    if (!ticket) {
      runner_.answerSupposition();
      continue;
    }
    runner_.run(*ticket);
    const std::lock_guard<std::mutex> lock(mutex_);
    current_.reset();
  }
}

}  // namespace goal_alignment::ros_interface
