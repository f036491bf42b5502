// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/question_watch.h"

#include <ros/init.h>

#include <algorithm>
#include <utility>

#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::dialogues {
namespace {

constexpr std::uint32_t kQueueSize = 10;
constexpr std::chrono::milliseconds kShutdownCheck{100};

}  // namespace

bool endsQuestion(const Question& shown, std::uint32_t newest, const Question& asked) {
  if (shown.question_id != 0) return shown.question_id > asked.question_id;
  return newest >= asked.question_id || shown.header.stamp > asked.header.stamp;
}

QuestionWatch::QuestionWatch(ros::NodeHandle node, std::function<void()> changed)
    : changed_(std::move(changed)), listener_(1, &callbacks_) {
  node.setCallbackQueue(&callbacks_);
  subscriber_ =
      node.subscribe(ros_common::kAlignerQuestionTopic, kQueueSize, &QuestionWatch::show, this);
  listener_.start();
}

void QuestionWatch::show(const Question::ConstPtr& question) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shown_ = *question;
    newest_ = std::max(newest_, question->question_id);
  }
  shown_changed_.notify_all();
  if (changed_) changed_();
}

bool QuestionWatch::isGone(const Question& asked) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return endsQuestion(shown_, newest_, asked);
}

bool QuestionWatch::waitUntilGone(const Question& asked,
                                  std::chrono::duration<double> at_most) const {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(at_most);
  std::unique_lock<std::mutex> lock(mutex_);
  while (!endsQuestion(shown_, newest_, asked) && ros::ok()) {
    const auto now = Clock::now();
    if (now >= deadline) return false;
    shown_changed_.wait_until(lock, std::min(deadline, now + kShutdownCheck));
  }
  return true;
}

}  // namespace goal_alignment::dialogues
