// SPDX-License-Identifier: BSD-3-Clause
#include "thinking_budget.h"

#include <chrono>
#include <limits>

namespace goal_alignment::session {

namespace {

double secondsSince(Limits::Clock::time_point start) {
  return std::chrono::duration<double>(Limits::Clock::now() - start).count();
}

}  // namespace

void ThinkingBudget::reset() {
  statistics_ = {};
  used_before_ = 0;
}

void ThinkingBudget::setLimits(double seconds, std::size_t bytes) {
  seconds_ = seconds;
  bytes_ = bytes;
}

void ThinkingBudget::renew() {
  used_before_ = statistics_.total;
  cancel_.reset();
}

void ThinkingBudget::start() {
  started_ = Limits::Clock::now();
  plan_before_ = statistics_.plan;
}

void ThinkingBudget::stop(double Statistics::*part, std::size_t planner_calls) {
  const double took = secondsSince(started_);
  statistics_.*part += took - (statistics_.plan - plan_before_);
  statistics_.total += took;
  statistics_.planner_calls = planner_calls;
}

bool ThinkingBudget::isUsedUp() const {
  return used() >= seconds_;
}

Limits ThinkingBudget::limits(double share_kept) const {
  Limits result = cancelOnly();
  result.bytes = accountable(bytes_);
  if (seconds_ == std::numeric_limits<double>::infinity()) return result;
  return result.withSeconds(seconds_ - share_kept * seconds_ - used() - secondsSince(started_));
}

Limits ThinkingBudget::cancelOnly() const {
  Limits result;
  result.cancel = &cancel_;
  return result;
}

Limits ThinkingBudget::limitsFor(double seconds) const {
  Limits result = cancelOnly();
  result.bytes = accountable(bytes_);
  return result.withSeconds(seconds);
}

}  // namespace goal_alignment::session
