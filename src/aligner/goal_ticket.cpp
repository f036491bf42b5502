// SPDX-License-Identifier: BSD-3-Clause
#include "goal_ticket.h"

#include <ros/console.h>
#include <ros/serialization.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/nil_generator.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

#include "goal_alignment/ros_common/outside_text.h"

namespace goal_alignment::aligner {

using actionlib_msgs::GoalStatus;

namespace {

using GoalPointer = boost::shared_ptr<const AlignGoal>;

GoalPointer withCleanNames(GoalPointer goal) {
  const std::string person = ros_common::outsideName(goal->task.person);
  const std::string task_id = ros_common::outsideName(goal->task.task_id);
  if (person == goal->task.person && task_id == goal->task.task_id) return goal;
  const auto clean = boost::make_shared<AlignGoal>(*goal);
  clean->task.person = person;
  clean->task.task_id = task_id;
  return clean;
}

}  // namespace

std::string identityOf(const AlignGoal& goal) {
  if (!goal.continue_session.empty()) return {};
  AlignGoal plain = goal;
  plain.task.header = {};
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(plain));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, plain);
  const boost::uuids::name_generator_sha1 name(boost::uuids::nil_uuid());
  return boost::uuids::to_string(name(bytes.data(), bytes.size()));
}

GoalTicket::GoalTicket(Handle handle)
    : handle_(std::move(handle)),
      goal_(withCleanNames(handle_.getGoal())),
      identity_(identityOf(*goal_)) {
  interim_.failing_step = -1;
}

GoalTicket::~GoalTicket() {
  try {
    sendResult({});  // does nothing if one was sent
  } catch (const std::exception& error) {
    ROS_ERROR("a goal ends without a result: %s", error.what());
  }
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

void GoalTicket::sendResult(AlignResult result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (std::exchange(result_sent_, true)) return;
  if (result.outcome == AlignResult::NONE) {
    result.failing_step = -1;
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

}  // namespace goal_alignment::aligner
