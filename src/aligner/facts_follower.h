// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/spatial_facts/observer.h"
#include "robot_facts.h"
#include "session_record.h"
#include "tf_state_bridge.h"

namespace goal_alignment::aligner {

/// Keeps the current session's robot state up to date with ~set_facts and tf. While tf does not
/// tell all facts that its rules own, a session that has not begun to plan waits for them, and one
/// that has keeps what it knew; after ~tf_timeout seconds either ends as StateUnknown. Belongs to
/// the solver thread.
class FactsFollower {
 public:
  using Clock = std::chrono::steady_clock;
  /// Takes one line for people.
  using Tell = std::function<void(const std::string&)>;

  /// All outlive this.
  FactsFollower(const SessionRecord& current, RobotFacts& facts, TfStateBridge& tf, Tell tell);

  /// Another session has begun: nothing was seen for it yet.
  void beginSession();
  /// A goal has begun. It needs the facts anew, also where it continues a session.
  void beginGoal();
  /// The session has loaded its models. Rules that the robot's model can't satisfy end the
  /// session, as a faulty model would.
  void onModelsLoaded();

  /// Passes to the session what has changed.
  void update();
  /// The session can't go on before tf tells the missing facts.
  bool mustWait() const;
  /// Which facts are missing now, as one sentence; empty: none.
  std::string missingFacts() const;
  /// Facts are missing, but not for too long yet.
  bool isWithinTimeout();
  /// While a question is open: update() would change something.
  bool haveChanged();
  /// When to look at tf again; the largest time point: never.
  Clock::time_point nextLook() const;

 private:
  bool hasTimeLeft();
  void apply(const spatial_facts::Observation& seen, bool is_first);

  const SessionRecord& current_;
  RobotFacts& facts_;
  TfStateBridge& tf_;
  const Tell tell_;
  unsigned applied_version_ = 0;  // RobotFacts::version()
  spatial_facts::Observation applied_;
  bool complete_ = false;  // they were, since the goal began
  std::optional<Clock::time_point> incomplete_since_;
  std::set<GroundName> reported_left_out_;
};

}  // namespace goal_alignment::aligner
