// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <string>

namespace goal_alignment::dialogues {

/// Lines from a file descriptor that never block their reader: a terminal or a pipe.
///
/// On a terminal every line is read as it comes. From a pipe at most a few lines are read ahead, so
/// that prepared answers wait for their questions and the end of input is seen after the last one.
class LineReader {
 public:
  /// `input` is not owned. `wake` is a descriptor that ends wait() when it becomes readable.
  LineReader(int input, int wake);

  /// Waits for input, for `wake`, or for the time to pass; reads what there is.
  void wait(std::chrono::milliseconds at_most);

  std::optional<std::string> nextLine();

  /// No line is left and none will come.
  bool atEnd() const { return ended_ && lines_.empty(); }

  bool isTerminal() const { return terminal_; }

 private:
  void readAvailable();
  void cutLines();

  int input_;
  int wake_;
  bool terminal_;
  bool ended_ = false;
  std::string partial_;
  std::deque<std::string> lines_;
};

}  // namespace goal_alignment::dialogues
