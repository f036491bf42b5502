// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/AskHuman.h"
#include "goal_alignment/phrasing/reply.h"
#include "goal_alignment/ros_interface/line_reader.h"
#include "goal_alignment/ros_interface/question_watch.h"

namespace goal_alignment::ros_interface {

/// Answers `ask_human` by asking a person in a terminal. Leaves a question at once when `~question`
/// shows that it is over; ends at the end of input and at shutdown, even while it waits for a line.
class ConsoleDialogue {
 public:
  /// It speaks the language of `phrases`.
  ConsoleDialogue(ros::NodeHandle node, int input, std::ostream& out,
                  phrasing::Phrases phrases = {});

  /// Talks to the person until the input ends or the node shuts down. The calling thread alone
  /// reads and writes the terminal; callbacks must run in others.
  void run();

 private:
  using Clock = std::chrono::steady_clock;

  // Wakes the terminal's thread from others.
  struct WakePipe {
    WakePipe();
    ~WakePipe();
    WakePipe(const WakePipe&) = delete;
    WakePipe& operator=(const WakePipe&) = delete;
    std::array<int, 2> ends{};
  };

  bool ask(AskHuman::Request& request, AskHuman::Response& response);
  void wake() const;
  void showNewQuestion();
  void leaveQuestionIfGone();
  void treatLine(const std::string& line);
  void finish(const std::optional<phrasing::Reply>& reply);
  void sayGoodbye();
  bool cameTooEarly() const;

  std::ostream& out_;
  const phrasing::Phrases phrases_;
  WakePipe wake_pipe_;
  LineReader lines_;

  std::mutex asking_;  // one question at a time, whoever asks
  std::mutex mutex_;   // guards the five below
  std::condition_variable answered_;
  std::optional<Question> question_;
  bool finished_ = false;  // the question was answered, or left without a reply
  std::optional<phrasing::Reply> reply_;
  bool ended_ = false;

  // Of the terminal's thread alone.
  std::uint32_t shown_id_ = 0;
  bool replaced_another_ = false;  // the question before this one vanished under the person's hands
  Clock::time_point shown_at_;

  QuestionWatch watch_;
  ros::ServiceServer service_;
};

}  // namespace goal_alignment::ros_interface
