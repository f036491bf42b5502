// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace goal_alignment::dialogues {

/// A program that says something, without a shell and in a process group of its own, so that what
/// it starts stops with it. Of one thread.
class SpeechProcess {
 public:
  SpeechProcess() = default;
  /// Stops it.
  ~SpeechProcess();
  SpeechProcess(const SpeechProcess&) = delete;
  SpeechProcess& operator=(const SpeechProcess&) = delete;

  /// Starts `command`: a program, looked for on PATH where it has no slash, and its arguments.
  /// False where there is no such program; throws std::system_error where it can't be started for
  /// another reason. What still runs is stopped first.
  bool start(const std::vector<std::string>& command);

  /// Never waits.
  bool isRunning();

  /// Ends it, by force if it does not go when it is told to; returns within half a second.
  void stop();

  /// How the last one ended: its exit status, or 128 and the signal's number.
  int lastStatus() const { return last_status_; }

 private:
  bool waitAtMost(std::chrono::milliseconds time);

  pid_t process_ = 0;  // 0: none
  int last_status_ = 0;
};

}  // namespace goal_alignment::dialogues
