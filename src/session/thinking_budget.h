// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::session {

/// How long a session may think and how much memory that may take, and where the time went. Only
/// the time between start() and stop() counts: a person who is asked may take as long as they like.
class ThinkingBudget {
 public:
  ThinkingBudget(double seconds, std::size_t bytes) : seconds_(seconds), bytes_(bytes) {}

  /// A new task: nothing is used up, and nothing has been counted. A cancel that came before stays.
  void reset();
  void setLimits(double seconds, std::size_t bytes);
  /// From now on all the time is there once more. A cancel is forgotten: it came after an outcome
  /// and had nothing left to end.
  void renew();

  /// One turn of thinking begins.
  void start();
  /// It ends: its time counts for this part, but for what of it went into the final plan.
  void stop(double Statistics::*part, std::size_t planner_calls);
  /// So many seconds of the turn went into the final plan.
  void addPlanTime(double seconds) { statistics_.plan += seconds; }

  /// Whether the turns since the last renew() have taken all the time.
  bool isUsedUp() const;

  /// What is left but for this share of the whole time, which is kept for what comes later.
  Limits limits(double share_kept = 0) const;
  /// For the check of a plan once it is found: it must not be lost where the search for a better
  /// one has used up the time.
  Limits cancelOnly() const;
  /// For work that the time limit does not count.
  Limits limitsFor(double seconds) const;

  double seconds() const { return seconds_; }
  const Statistics& statistics() const { return statistics_; }
  CancelToken& cancel() { return cancel_; }

 private:
  /// Used up by the turns since the last renew().
  double used() const { return statistics_.total - used_before_; }

  alignas(64) CancelToken cancel_;  // apart from what the thread that works reads and writes
  alignas(64) double seconds_;
  std::size_t bytes_;
  Limits::Clock::time_point started_;
  Statistics statistics_;
  double used_before_ = 0;  // the last renew()
  double plan_before_ = 0;  // the last start(): of Statistics::plan
};

}  // namespace goal_alignment::session
