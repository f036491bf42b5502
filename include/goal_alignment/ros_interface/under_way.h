// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace goal_alignment::ros_interface {

/// A note on disk of the task that a node is at, so that one that was killed can say, when it is
/// back, which task ended with it. A folder that can't be written to is complained of once. Of the
/// solver thread, but for the constructor's and lost().
class UnderWay {
 public:
  struct Task {
    std::string session_id;
    std::string task_id;
    std::string person;
  };
  /// Takes one line for people.
  using Complain = std::function<void(const std::string&)>;

  /// `robot` is the name of its node.
  UnderWay(const std::string& folder, const std::string& robot, Complain complain);

  void begin(const Task& task);
  void end();

  /// The task that a run of the node before this one did not end; it is told once.
  std::optional<Task> lost();

 private:
  const std::string file_;
  const Complain complain_;
  bool noted_ = false;
  bool complained_ = false;
};

}  // namespace goal_alignment::ros_interface
