// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace goal_alignment::aligner {

/// Question ids that never repeat, across restarts either, nor between nodes that share a
/// $ROS_HOME: a file holds the first id that nobody has reserved, and every process reserves a
/// block at a time. Where the file can't be used, ids begin with the seconds of the wall clock.
/// Not thread-safe.
class QuestionIds {
 public:
  explicit QuestionIds(std::string file);

  std::uint32_t next();

  /// Whether this object gave the id out.
  bool issued(std::uint32_t id) const { return id >= first_ && id < next_ && id != 0; }

  /// Why the file can't be used; empty: it can.
  const std::string& lastError() const { return last_error_; }

 private:
  void reserveBlock();

  std::string file_;
  std::string last_error_;
  std::uint32_t first_ = 0;
  std::uint32_t next_ = 0;
  std::uint32_t end_ = 0;
};

}  // namespace goal_alignment::aligner
