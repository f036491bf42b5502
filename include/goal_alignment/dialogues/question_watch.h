// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>

#include "goal_alignment/Question.h"

namespace goal_alignment::dialogues {

/// Tells a dialogue node that the question it was asked is no longer open, because another
/// answerer was faster or the task ended. It listens on a thread of its own: however many ask_human
/// calls wait in the node's callbacks, the end of their question is heard. Thread-safe.
class QuestionWatch {
 public:
  /// `changed` is called from the listening thread after every message; it may be empty.
  explicit QuestionWatch(ros::NodeHandle node, std::function<void()> changed = {});

  bool isGone(const Question& asked) const;

  /// Waits in wall time; true as soon as the question is gone or the node shuts down.
  bool waitUntilGone(const Question& asked, std::chrono::duration<double> at_most) const;

 private:
  void show(const Question::ConstPtr& question);

  std::function<void()> changed_;
  mutable std::mutex mutex_;
  mutable std::condition_variable shown_changed_;
  Question shown_;            // question_id 0 until the first message
  std::uint32_t newest_ = 0;  // id ever shown
  ros::CallbackQueue callbacks_;
  ros::Subscriber subscriber_;
  ros::AsyncSpinner listener_;
};

/// Whether `shown` on ~question means that `asked` is over; `newest` is the largest id shown so
/// far. Ids only grow. A request may come before the message that shows it, so an older id proves
/// nothing, and "none is open" only after the question itself was shown, or with a later stamp.
bool endsQuestion(const Question& shown, std::uint32_t newest, const Question& asked);

}  // namespace goal_alignment::dialogues
