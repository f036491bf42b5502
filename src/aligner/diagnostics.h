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

#include "announcer.h"
#include "journal.h"

namespace goal_alignment::aligner {

/// The aligner on /diagnostics, once a second of wall time: phase, last outcome, the open question
/// and its age, who has answered, and what is wrong with the journal. A WARN asks somebody to look:
/// a question nobody answers, a journal that can't be written; an ERROR is a fault of ours.
class Diagnostics {
 public:
  Diagnostics(ros::NodeHandle node, ros::NodeHandle private_node, const Announcer& announcer,
              const Journal& journal);

  /// Somebody's answer was accepted. Of any thread.
  void countAnswer(const std::string& answered_by);

 private:
  using Clock = std::chrono::steady_clock;

  void report(diagnostic_updater::DiagnosticStatusWrapper& status);
  void addQuestion(diagnostic_updater::DiagnosticStatusWrapper& status);
  void addAnswerers(diagnostic_updater::DiagnosticStatusWrapper& status);

  const Announcer& announcer_;
  const Journal& journal_;

  std::mutex mutex_;  // guards the two below
  std::map<std::string, std::size_t> answerers_;
  std::size_t other_answers_ = 0;  // of people beyond those that are counted by name

  // Of the timer alone.
  std::string last_outcome_ = "none";
  Question open_;
  Clock::time_point open_since_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace goal_alignment::aligner
