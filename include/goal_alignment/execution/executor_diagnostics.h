// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>
#include <string>

namespace goal_alignment::execution {

/// An executor on /diagnostics, once a second of wall time: the plan under way and its step, how
/// the last one ended, and servers that are missing. A WARN asks somebody to look: a plan that
/// failed, a server that is not there; an ERROR is a fault of ours. Thread-safe.
class ExecutorDiagnostics {
 public:
  ExecutorDiagnostics(ros::NodeHandle node, const ros::NodeHandle& private_node);

  void begin(int plan_id, std::size_t steps);
  void follow(int step, const std::string& text);
  /// `outcome` is one of ExecutePlanResult.
  void end(std::uint16_t outcome, const std::string& reason);
  void setMissing(const std::set<std::string>& servers);

 private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  std::mutex mutex_;  // guards all up to the updater
  int plan_id_ = 0;   // 0: none is under way
  std::size_t steps_ = 0;
  std::string step_;
  std::uint16_t outcome_ = 0;
  std::string outcome_text_ = "none";
  std::set<std::string> missing_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace goal_alignment::execution
