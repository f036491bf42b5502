// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/AlternativeGoal.h"
#include "goal_alignment/Plan.h"

namespace goal_alignment::dialogues {

/// Hears for a dialogue node how tasks end, and takes up the alternative that a person has chosen.
/// It listens on a thread of its own. Thread-safe.
class OutcomeWatch {
 public:
  /// `changed` is called from the listening thread after every message; it may be empty.
  explicit OutcomeWatch(ros::NodeHandle node, std::function<void()> changed = {});

  /// The newest end that was not taken yet. Not what had ended before this one listened, and not
  /// what was canceled: whoever did so knows.
  std::optional<AlignmentState> takeEnd();

  /// Whether the aligner is at something else, so that what this end offers can't be taken up.
  bool isGone(const AlignmentState& end) const;

  /// The plan that this end is about, once. Nothing where it was not heard yet: it comes on another
  /// topic.
  std::optional<Plan> takePlan(const AlignmentState& end);

  /// Goes on with the session of this end; false where nobody takes tasks.
  bool takeUp(const AlignmentState& end, const AlternativeGoal& alternative,
              const std::string& person);

 private:
  void hearState(const AlignmentState::ConstPtr& state);
  void hearPlan(const Plan::ConstPtr& plan);

  std::function<void()> changed_;
  ros::Time began_;
  mutable std::mutex mutex_;
  std::optional<AlignmentState> newest_;  // nothing until the first message
  std::optional<AlignmentState> end_;     // not taken yet
  std::optional<Plan> plan_;              // not taken yet
  std::uint32_t taken_up_ = 0;
  ros::CallbackQueue callbacks_;
  ros::Publisher goals_;
  ros::Subscriber states_;
  ros::Subscriber plans_;
  ros::AsyncSpinner listener_;
};

/// What an alternative leaves out, in words.
std::string leftOutBy(const AlternativeGoal& alternative);

}  // namespace goal_alignment::dialogues
