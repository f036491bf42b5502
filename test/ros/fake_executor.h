// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "scenario.h"

namespace goal_alignment::test {

/// Says what an executor of plans says of its goals, over and over, until it is told to be silent.
class FakeExecutor {
 public:
  explicit FakeExecutor(ros::NodeHandle node);
  ~FakeExecutor();

  bool isHeard() const { return status_.getNumSubscribers() > 0; }
  /// A plan is being carried out from now on.
  void begin();
  /// It has been, or never was.
  void finish();
  void fallSilent() { silent_ = true; }

 private:
  void talk();

  ros::Publisher status_;
  std::mutex mutex_;  // guards the one below
  actionlib_msgs::GoalStatusArray goals_;
  int begun_ = 0;
  std::atomic<bool> silent_{false};
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace goal_alignment::test
