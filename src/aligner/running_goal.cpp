// SPDX-License-Identifier: BSD-3-Clause
#include "running_goal.h"

#include <utility>

namespace goal_alignment::aligner {

void RunningGoal::begin(const GoalTicket& ticket, std::shared_ptr<session::Session> session) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ticket_ = &ticket;
  session_ = std::move(session);
}

void RunningGoal::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ticket_ = nullptr;
  session_.reset();
}

bool RunningGoal::claimOutcome(GoalTicket& ticket) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ticket_ = nullptr;
  if (ticket.claim()) return true;
  if (session_->state() != session::State::Done) {
    session_->cancel();
    session_->step();
  }
  return false;
}

bool RunningGoal::cancel(GoalTicket& ticket) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!ticket.claim()) return false;
  if (ticket_ == &ticket) session_->cancel();
  return true;
}

}  // namespace goal_alignment::aligner
