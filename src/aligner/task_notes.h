// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace goal_alignment::aligner {

/// A note on disk of the task that a node is at and of those that wait, so that a node that was
/// killed can say, when it is back, which tasks ended with it. A folder that can't be written to is
/// complained of once. Thread-safe.
class TaskNotes {
 public:
  struct Task {
    std::string session_id;
    std::string task_id;
    std::string person;
  };
  struct Tasks {
    std::optional<Task> running;
    std::vector<Task> waiting;  ///< without a session
  };
  /// Takes one line for people.
  using ErrorCallback = std::function<void(const std::string&)>;

  /// `robot` is the name of its node.
  TaskNotes(const std::string& folder, const std::string& robot, ErrorCallback complain);

  void begin(const Task& task);
  void end();
  /// These wait from now on.
  void setWaiting(std::vector<Task> tasks);

  /// The tasks that a run of the node before this one did not end; they are told once.
  Tasks takeLost();

 private:
  void write();  // needs mutex_

  const std::string file_;
  const ErrorCallback report_error_;
  std::mutex mutex_;  // guards the three below
  Tasks now_;
  bool noted_ = false;
  bool complained_ = false;
};

}  // namespace goal_alignment::aligner
