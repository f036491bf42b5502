// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2_ros/buffer.h>

#include <memory>
#include <mutex>
#include <optional>

#include "goal_alignment/spatial_facts/observer.h"
#include "goal_alignment/spatial_facts/rules.h"

namespace goal_alignment::aligner {

/// Looks at tf for the rules that make facts of it. Thread-safe; nothing waits for a transform.
class TfStateBridge {
 public:
  /// `frames` hears tf and outlives this.
  explicit TfStateBridge(const tf2_ros::Buffer& frames);

  /// From now on these rules count; null: none. What was seen under rules of the same text is
  /// remembered.
  void follow(std::shared_ptr<const spatial_facts::Rules> rules);

  /// Null: none.
  std::shared_ptr<const spatial_facts::Rules> rules() const;

  /// What the rules make of the newest transforms. Ages are measured in ROS time.
  spatial_facts::Observation look();

 private:
  const tf2_ros::Buffer& frames_;
  mutable std::mutex mutex_;  // guards all below
  std::optional<spatial_facts::Observer> observer_;
};

}  // namespace goal_alignment::aligner
