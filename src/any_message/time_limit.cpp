// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/time_limit.h"

#include <algorithm>

namespace goal_alignment::any_message {

Timer::Timer(ClockKind kind) : kind_(kind) {
  if (kind == ClockKind::Ros) last_ = ros::Time::now();
}

double Timer::seconds() {
  if (kind_ == ClockKind::Wall) return std::chrono::duration<double>(Clock::now() - begin_).count();
  const ros::Time now = ros::Time::now();
  if (!last_.isZero() && now > last_) passed_ += now.toSec() - last_.toSec();
  last_ = now;
  return passed_;
}

TimeLimit TimeLimit::after(double seconds, ClockKind kind) {
  TimeLimit limit;
  if (seconds <= 0) return limit;
  if (kind == ClockKind::Wall) return deadlineIn(seconds);
  limit.timer_ = std::make_shared<Timer>(kind);
  limit.seconds_ = seconds;
  return limit;
}

bool TimeLimit::isOver() const {
  return Clock::now() >= wall_ || (timer_ && timer_->seconds() >= seconds_);
}

TimeLimit TimeLimit::capped(Clock::time_point wall) const {
  TimeLimit limit = *this;
  limit.wall_ = std::min(wall_, wall);
  return limit;
}

}  // namespace goal_alignment::any_message
