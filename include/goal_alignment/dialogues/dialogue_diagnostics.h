// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>

#include "goal_alignment/AskHuman.h"

namespace goal_alignment::dialogues {

/// A dialogue node on /diagnostics, once a second of wall time: the question that it puts just now
/// and for how long it has done so, how many it has put, answered and left unanswered, and who
/// answered last. Always OK: that nobody answers is what the aligner warns about.
class DialogueDiagnostics {
 public:
  DialogueDiagnostics(ros::NodeHandle node, ros::NodeHandle private_node);

  /// While it lives, its question is put to somebody. `response` is read at its end.
  class Turn {
   public:
    Turn(DialogueDiagnostics& diagnostics, const AskHuman::Request& request,
         const AskHuman::Response& response);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    DialogueDiagnostics& diagnostics_;
    const AskHuman::Response& response_;
    std::size_t number_;
  };

 private:
  using Clock = std::chrono::steady_clock;

  // A question that somebody has asked this node to put.
  struct Open {
    std::string text;
    Clock::time_point since;
  };

  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  std::mutex mutex_;  // guards the five below
  std::size_t put_ = 0;
  std::size_t answered_ = 0;
  std::size_t unanswered_ = 0;
  std::string last_answered_by_ = "nobody yet";
  std::map<std::size_t, Open> open_;  // by the number of the turn, so that the oldest comes first

  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace goal_alignment::dialogues
