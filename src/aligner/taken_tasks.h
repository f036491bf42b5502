// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <string>

namespace goal_alignment::aligner {

/// Remembers in a file which latched tasks were taken up, so that a node that starts again does not
/// take up again what it is shown only because it is new. Not thread-safe.
class TakenTasks {
 public:
  /// Takes one line for people.
  using ErrorCallback = std::function<void(const std::string&)>;

  TakenTasks(std::string file, ErrorCallback complain);

  /// The newest keys of all that were added, in this life or an earlier one.
  bool knows(const std::string& key) const;
  void add(const std::string& key);

 private:
  void write() const;

  const std::string file_;
  const ErrorCallback report_error_;
  std::deque<std::string> keys_;
  bool complained_ = false;
};

}  // namespace goal_alignment::aligner
