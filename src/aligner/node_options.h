// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include <map>
#include <string>
#include <vector>

#include "goal_alignment/ros_common/parameter_reader.h"
#include "goal_alignment/session/options.h"

namespace goal_alignment::aligner {

/// What becomes of a task that arrives while a plan is being carried out.
enum class BusyPolicy { Wait, Refuse };

/// All parameters of goal_alignment_node, read anew for every goal. config/goal_alignment.yaml
/// lists them in this order.
struct NodeOptions {
  // Files, absolute or relative to the package's folder; "" where a goal brings its own models.
  std::string robot_domain;
  std::string robot_problem;
  std::string human_domain;
  std::string human_problem;
  std::string phrases;  ///< YAML templates; "": fluents are read out as they are written

  /// policy, seed (0 … 2^31-1), belief (normalised, raw, flat:P), beta (0 … 1000), kappa
  /// (0.001 … 1000), conflicts (lazy, full), unsure_policy (as-yes, defer, abort), plan (first,
  /// optimal), costs, static_candidates, time_limit (seconds of wall time spent thinking, 0.01 …
  /// 86400, default 300), memory_limit (MiB, 16 … 1048576, default 2048), max_questions (-1: no
  /// limit), max_group_size (1 … 255), negative_candidates, assumed_wanted_predicates and
  /// assumed_unwanted_predicates (lists of predicates, none in both), max_extra_cost (0 … 10^9; -1:
  /// no limit).
  session::Options session;

  /// Seconds of wall time to wait for one answer, 0 … 604800; 0: for ever.
  double ask_timeout = 0;
  int ask_retries = 0;  ///< 0 … 1000: how often a question is put again after such silence

  /// Seconds of wall time, 0 … 31536000: for so long the answers of a dialogue that was broken off
  /// are kept on disk; 0: not at all.
  double journal_expiry = 604800;

  BusyPolicy busy_policy = BusyPolicy::Wait;  ///< wait, refuse
  /// Whether what the robot reports is so for the person as well, in later tasks.
  bool human_state_follows = true;
  /// Seconds, 0 … 31536000: for so long facts that were set are kept on disk for after a restart;
  /// 0: not at all. Read at the start alone, like the next one.
  double facts_expiry = 604800;
  std::string world;  ///< kept facts hold in the world of this name alone

  std::string tf_facts;  ///< YAML file: facts from where things are; "": none
  double tf_timeout = 2;  ///< seconds of wall time, 0 … 3600: for so long unknown facts are awaited
  double tf_period = 0.2;  ///< seconds of wall time, 0.01 … 60: how often tf is looked at meanwhile

  double diagnostic_period = 1;  ///< seconds of wall time, 0.01 … 3600; read at the start alone

  bool markers = true;  ///< whether anything is shown on ~markers
  /// The tf frames of objects, for markers; that of another object has its name.
  std::map<std::string, std::string> marker_frames;

  std::vector<std::string> warnings;  ///< unknown and renamed parameters, a sentence each

  NodeOptions();

  /// Reads the private namespace of a node with one call to the parameter server.
  static NodeOptions read(const ros::NodeHandle& private_node);

  /// The same from values at hand: a struct, or an invalid value for no parameters at all.
  /// Throws ParameterError at the first fault.
  static NodeOptions read(const XmlRpc::XmlRpcValue& values, const std::string& ns);
};

}  // namespace goal_alignment::aligner
