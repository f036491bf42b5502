// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <map>
#include <mutex>
#include <string>

#include "goal_alignment/any_message/wait_point.h"

namespace goal_alignment::execution {

/// Which nodes hear the dispatched steps. Thread-safe.
class DispatchListeners {
 public:
  /// The publisher of `action_dispatch`; this must outlive it.
  ros::Publisher advertise(ros::NodeHandle node);

  /// Whether the node has heard what is dispatched, and does so no more, for longer than it takes
  /// to link up again.
  bool hasLeft(const std::string& node) const;

 private:
  struct Links {
    int count = 0;
    any_message::Clock::time_point last_cut;
  };

  mutable std::mutex mutex_;  // guards the one below
  std::map<std::string, Links> links_;
};

}  // namespace goal_alignment::execution
