// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "goal_alignment/whereabouts/observer.h"
#include "goal_alignment/whereabouts/rules.h"

namespace goal_alignment::ros_interface {

/// Looks at tf for the rules that make facts of it. Listens only while there are rules.
/// Thread-safe; nothing waits for a transform.
class TfStateBridge {
 public:
  TfStateBridge();
  ~TfStateBridge();

  /// From now on these rules count; null: none. What was seen under rules of the same text is
  /// remembered.
  void follow(std::shared_ptr<const whereabouts::Rules> rules);

  /// Null: none.
  std::shared_ptr<const whereabouts::Rules> rules() const;

  /// What the rules make of the newest transforms. Ages are measured in ROS time.
  whereabouts::Observation look();

 private:
  struct Listening;

  mutable std::mutex mutex_;  // guards all below
  std::unique_ptr<Listening> listening_;
  std::optional<whereabouts::Observer> observer_;
};

}  // namespace goal_alignment::ros_interface
