// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

namespace goal_alignment::aligner {

/// Tells a task that somebody wants again from one that is only published over and over, as
/// `rostopic pub -r 10` does. Not thread-safe.
class TaskRepeats {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Verdict {
    Wanted,
    Repeated,
    RepeatedToTell,  ///< and nobody was told of it lately
  };

  /// A task was published. `under_way`: an equal one is. What was repeated while it was under way
  /// stays one wish for as long as it is repeated without a pause; so does what comes again faster
  /// than a person presses a button, or for the third time without a pause.
  Verdict judge(const std::string& publisher, const std::string& identity, bool under_way,
                Clock::time_point now);

 private:
  struct Series {
    Clock::time_point last;
    unsigned copies = 0;
    bool merged = false;  // a copy was, since the last pause
    Clock::time_point told;
  };

  void forgetOld(Clock::time_point now);

  std::map<std::pair<std::string, std::string>, Series> series_;
};

}  // namespace goal_alignment::aligner
