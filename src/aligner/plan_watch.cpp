// SPDX-License-Identifier: BSD-3-Clause
#include "plan_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace goal_alignment::aligner {
namespace {

using actionlib_msgs::GoalStatus;

// An executor says five times a second what it is at, also while it waits; a busy machine is slow.
constexpr std::chrono::seconds kSilence{5};
// From a plan to the executor's word that it has it.
constexpr std::chrono::seconds kTakeUp{3};

// A goal that is RECALLING was canceled before it began.
bool isActive(const GoalStatus& goal) {
  return goal.status == GoalStatus::PENDING || goal.status == GoalStatus::ACTIVE ||
         goal.status == GoalStatus::PREEMPTING;
}

}  // namespace

PlanWatch::PlanWatch(std::function<Clock::time_point()> now) : now_(std::move(now)) {}

void PlanWatch::onPlanPublished(PublishedPlan plan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  last_ = std::move(plan);
  const auto now = now_();
  // One that is at work has asked for the plan itself, and goes on with it under the same goal.
  if (standingAt(now) != Standing::Busy) undecided_since_ = now;
}

void PlanWatch::onExecutorStatus(const std::vector<GoalStatus>& goals) {
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_ = now_();
  ++status_count_;
  std::set<std::string> known;
  active_goal_.clear();
  for (const GoalStatus& goal : goals) {
    known.insert(goal.goal_id.id);
    if (isActive(goal)) active_goal_ = goal.goal_id.id;
    // Also one that has ended by now: a plan without steps takes no time.
    if (known_goals_.count(goal.goal_id.id) == 0) undecided_since_.reset();
  }
  known_goals_ = std::move(known);
}

bool PlanWatch::isPresent(Clock::time_point now) const {
  return heard_ && now - *heard_ < kSilence;
}

PlanWatch::Standing PlanWatch::standingAt(Clock::time_point now) const {
  if (!isPresent(now)) return Standing::Idle;
  if (!active_goal_.empty()) return Standing::Busy;
  const bool may_begin = undecided_since_ && now - *undecided_since_ < kTakeUp;
  return may_begin ? Standing::Undecided : Standing::Idle;
}

PlanWatch::Standing PlanWatch::standing() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return standingAt(now_());
}

unsigned PlanWatch::statusCount() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_count_;
}

PlanWatch::Clock::time_point PlanWatch::nextChange() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Standing standing = standingAt(now_());
  if (standing == Standing::Idle) return Clock::time_point::max();
  const Clock::time_point gone = *heard_ + kSilence;
  return standing == Standing::Busy ? gone : std::min(gone, *undecided_since_ + kTakeUp);
}

bool PlanWatch::isExecuting(const std::string& identity) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return standingAt(now_()) == Standing::Busy && last_ && last_->identity == identity;
}

std::string PlanWatch::description() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!last_) return fmt::format("a plan ({}) is being carried out", active_goal_);
  std::string task;
  if (!last_->task_id.empty()) task = " for the task " + last_->task_id;
  if (!last_->person.empty()) task += (task.empty() ? " for " : " of ") + last_->person;
  return fmt::format("plan {}{} is being carried out", last_->plan_id, task);
}

}  // namespace goal_alignment::aligner
