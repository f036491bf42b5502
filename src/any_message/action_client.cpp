// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/action_client.h"

#include <fmt/format.h>
#include <ros/serialization.h>
#include <ros/this_node.h>
#include <std_msgs/Header.h>

#include <algorithm>
#include <atomic>

namespace goal_alignment::any_message {
namespace {

using actionlib_msgs::GoalStatus;
namespace serialization = ros::serialization;

constexpr std::uint32_t kQueueSize = 100;
constexpr std::chrono::seconds kResultDelay{2};  // after a status that says that the goal has ended
constexpr double kMinPatience = 0.5;  // seconds; links take a moment, and so do status lists

bool isTerminal(std::uint8_t status) {
  return status == GoalStatus::SUCCEEDED || status == GoalStatus::ABORTED ||
         status == GoalStatus::PREEMPTED || status == GoalStatus::REJECTED ||
         status == GoalStatus::RECALLED || status == GoalStatus::LOST;
}

template <typename Message>
void appendMessage(Bytes& bytes, const Message& message) {
  const std::size_t before = bytes.size();
  const std::uint32_t length = serialization::serializationLength(message);
  bytes.resize(before + length);
  serialization::OStream out(bytes.data() + before, length);
  serialization::serialize(out, message);
}

Bytes bytesOf(const topic_tools::ShapeShifter& message) {
  Bytes bytes(message.size());
  serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.write(out);
  return bytes;
}

std::string newId(const ros::Time& now) {
  static std::atomic<unsigned> number{0};
  return fmt::format("{}-{}-{}", ros::this_node::getName(), ++number, now.toNSec());
}

}  // namespace

ActionClient::ActionClient(const ros::NodeHandle& node, const std::string& name, GoalType type,
                           WaitPoint& wait)
    : name_(name), type_(std::move(type)), wait_(wait) {
  ros::NodeHandle inner(node, name);
  ros::AdvertiseOptions options("goal", kQueueSize, type_.md5, type_.name, type_.text);
  // One that was started anew must be heard anew: its predecessor's result topic still counts.
  options.disconnect_cb = [this](const ros::SingleSubscriberPublisher& /*gone*/) {
    const std::lock_guard<std::mutex> lock(mutex_);
    status_heard_ = false;
  };
  goals_ = inner.advertise(options);
  cancels_ = inner.advertise<actionlib_msgs::GoalID>("cancel", kQueueSize);
  results_ = inner.subscribe("result", kQueueSize, &ActionClient::hearResult, this);
  statuses_ = inner.subscribe("status", kQueueSize, &ActionClient::hearStatus, this);
}

bool ActionClient::connected() const {
  const bool linked = goals_.getNumSubscribers() > 0 && cancels_.getNumSubscribers() > 0 &&
                      results_.getNumPublishers() > 0;
  const std::lock_guard<std::mutex> lock(mutex_);
  return linked && status_heard_;
}

void ActionClient::hearStatus(const actionlib_msgs::GoalStatusArray::ConstPtr& statuses) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    status_heard_ = true;
    missing_ = true;
    for (const GoalStatus& status : statuses->status_list) {
      if (id_.id.empty() || status.goal_id.id != id_.id) continue;
      if (isTerminal(status.status) && !(status_ && isTerminal(status_->status))) {
        terminal_at_ = Clock::now();
      }
      status_ = status;
      last_sign_ = Clock::now();
      missing_ = false;
    }
  }
  wait_.notify();
}

void ActionClient::hearResult(const topic_tools::ShapeShifter::ConstPtr& result) {
  const Bytes bytes = bytesOf(*result);
  serialization::IStream in(const_cast<std::uint8_t*>(bytes.data()),
                            static_cast<std::uint32_t>(bytes.size()));
  std_msgs::Header header;
  GoalStatus status;
  try {
    serialization::deserialize(in, header);
    serialization::deserialize(in, status);
  } catch (const std::exception& error) {
    ROS_WARN("%s/result is no result of an action: %s", name_.c_str(), error.what());
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (id_.id.empty() || status.goal_id.id != id_.id) return;
    result_status_ = status;
    result_.assign(in.getData(), in.getData() + in.getLength());
  }
  wait_.notify();
}

void ActionClient::send(const Bytes& goal, const ros::Time& now, const std::string& goal_id) {
  std_msgs::Header header;
  header.stamp = now;
  Bytes bytes;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    id_.id = goal_id.empty() ? newId(now) : goal_id;
    id_.stamp = header.stamp;
    status_.reset();
    result_status_.reset();
    result_.clear();
    last_sign_ = Clock::now();
    missing_ = false;
    appendMessage(bytes, header);
    appendMessage(bytes, id_);
  }
  bytes.insert(bytes.end(), goal.begin(), goal.end());
  topic_tools::ShapeShifter message;
  message.morph(type_.md5, type_.name, type_.text, "");
  serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.read(in);
  goals_.publish(message);
}

void ActionClient::cancel() {
  actionlib_msgs::GoalID id;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    id.id = id_.id;  // without a stamp, which would mean all goals until then
  }
  cancels_.publish(id);
}

bool ActionClient::hasEnded() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (result_status_) return true;
  return status_ && isTerminal(status_->status) && Clock::now() > terminal_at_ + kResultDelay;
}

// A server whose clock stands still may say nothing for long, but one that is gone has no link to
// us, and one that was started anew does not list the goal.
bool ActionClient::isLost(double patience) {
  const bool linked = goals_.getNumSubscribers() > 0;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (linked && !missing_) {
    last_sign_ = Clock::now();
    return false;
  }
  return Clock::now() > last_sign_ + std::chrono::duration<double>(patience);
}

ActionClient::End ActionClient::ending() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  End end;
  const GoalStatus& status = result_status_ ? *result_status_ : *status_;
  end.status = status.status;
  end.text = status.text;
  if (result_status_) end.result = result_;
  return end;
}

ActionClient::End ActionClient::run(const Bytes& goal, const ros::Time& now, const Limits& limits,
                                    const std::string& goal_id) {
  using Woken = WaitPoint::Woken;
  const auto kindOf = [](Woken woken) {
    return woken == Woken::Interrupt ? End::Kind::Interrupted : End::Kind::TimedOut;
  };
  const double patience = std::max(limits.patience, kMinPatience);
  const TimeLimit server_until = limits.end.capped(deadlineIn(patience));
  const Woken found = wait_.waitUntil(server_until, [this] { return connected(); });
  if (found == Woken::Interrupt) return {End::Kind::Interrupted, 0, "", {}, true};
  if (found == Woken::Timeout) return {End::Kind::NoServer, 0, "", {}, true};

  send(goal, now, goal_id);
  bool lost = false;
  const auto isOver = [&] { return hasEnded() || (lost = isLost(patience)); };
  const Woken woken = wait_.waitUntil(limits.end, isOver);
  if (woken == Woken::Holds && !lost) return ending();
  cancel();
  if (woken == Woken::Holds) return {End::Kind::Lost, 0, "", {}, true};
  End end{kindOf(woken), 0, "", {}, true};
  const Woken settled = wait_.settleUntil(deadlineIn(limits.cancel_timeout), isOver);
  if (settled == Woken::Timeout) {
    end.text = "it did not end when it was canceled";
    end.is_over = false;
  }
  if (settled != Woken::Holds || lost) return end;
  // It may have been faster than the cancel, and must not be done once more.
  const End ended = ending();
  return ended.status == GoalStatus::SUCCEEDED ? ended : end;
}

}  // namespace goal_alignment::any_message
