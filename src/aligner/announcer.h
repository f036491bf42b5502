// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/Question.h"
#include "goal_alignment/WaitingTask.h"

namespace goal_alignment::aligner {

/// The node's topics. Thread-safe.
class Announcer {
 public:
  explicit Announcer(ros::NodeHandle private_node);

  /// With the tasks that wait.
  void publish(AlignmentState state);
  /// The last state once more, with these tasks waiting from now on.
  void showWaiting(std::vector<WaitingTask> waiting);
  void publish(Plan plan);
  /// Returns the question as it went out, stamped.
  Question publish(Question question);
  void publishNoQuestion();
  /// One line for people, on ~events and in the log.
  void tell(const std::string& line);
  /// The same, of something that somebody should mend.
  void warn(const std::string& line);
  /// Whether anybody would hear an event.
  bool isHeard() const { return events_.getNumSubscribers() > 0; }

  // As last published.
  AlignmentState state() const;
  Question question() const;
  Plan plan() const;

 private:
  std::string publishEvent(const std::string& line);

  mutable std::mutex mutex_;  // guards the three below
  AlignmentState state_;
  Question question_;
  Plan plan_;
  ros::Publisher states_;
  ros::Publisher plans_;
  ros::Publisher questions_;
  ros::Publisher events_;
};

}  // namespace goal_alignment::aligner
