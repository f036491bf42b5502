// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatus.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace goal_alignment::aligner {

/// Whether a plan is being carried out, from what the executor says of its goals. An executor that
/// falls silent counts as gone; all in wall time. Thread-safe.
class PlanWatch {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Standing {
    Idle,
    Undecided,  ///< a plan went out a moment ago, and the executor may be about to begin it
    Busy,
  };

  /// A plan that went out.
  struct PublishedPlan {
    std::int32_t plan_id = 0;
    std::string task_id;
    std::string person;
    std::string identity;  ///< of the task, as GoalTicket has it
  };

  explicit PlanWatch(std::function<Clock::time_point()> now = Clock::now);

  /// Before anyone can have the plan.
  void onPlanPublished(PublishedPlan plan);
  /// All that the executor has on its list.
  void onExecutorStatus(const std::vector<actionlib_msgs::GoalStatus>& goals);

  Standing standing() const;
  /// How often the executor was heard.
  unsigned statusCount() const;
  /// When the standing may change although nothing more is heard; the largest time point: never.
  Clock::time_point nextChange() const;
  /// Whether the plan being carried out is one for this task.
  bool isExecuting(const std::string& identity) const;
  /// "plan 3 for the task tea of Ann is being carried out"; as if one were.
  std::string description() const;

 private:
  // All need the mutex.
  bool isPresent(Clock::time_point now) const;
  Standing standingAt(Clock::time_point now) const;

  const std::function<Clock::time_point()> now_;
  mutable std::mutex mutex_;  // guards all below
  std::optional<Clock::time_point> heard_;
  unsigned status_count_ = 0;
  std::set<std::string> known_goals_;
  std::string active_goal_;  // empty: none
  std::optional<PublishedPlan> last_;
  std::optional<Clock::time_point> undecided_since_;
};

}  // namespace goal_alignment::aligner
