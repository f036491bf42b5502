// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/goal_ticket.h"

#include <utility>

namespace goal_alignment::ros_interface {

using actionlib_msgs::GoalStatus;

GoalTicket::GoalTicket(Handle handle) : handle_(std::move(handle)), goal_(handle_.getGoal()) {
  interim_.failing_step = -1;
}

bool GoalTicket::cancelOvertookIt() const {
  const auto status = handle_.getGoalStatus().status;
  return status == GoalStatus::RECALLING || status == GoalStatus::PREEMPTING;
}

void GoalTicket::accept() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (claimed_ || accepted_) return;
  handle_.setAccepted();
  accepted_ = true;
}

void GoalTicket::publishFeedback(const AlignFeedback& feedback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!claimed_) handle_.publishFeedback(feedback);
}

void GoalTicket::setInterim(const AlignResult& interim) {
  const std::lock_guard<std::mutex> lock(mutex_);
  interim_ = interim;
}

AlignResult GoalTicket::interim() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return interim_;
}

void GoalTicket::conclude(AlignResult result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (result.outcome == AlignResult::NONE) {
    result.outcome = AlignResult::INTERNAL;
    result.message = "the alignment ended without an outcome";
  }
  if (result.outcome == AlignResult::SUCCESS) {
    handle_.setSucceeded(result, result.message);
  } else if (result.outcome == AlignResult::CANCELED) {
    handle_.setCanceled(result, result.message);
  } else if (accepted_) {
    handle_.setAborted(result, result.message);
  } else {
    handle_.setRejected(result, result.message);
  }
}

}  // namespace goal_alignment::ros_interface
