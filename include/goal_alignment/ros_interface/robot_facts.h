// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "goal_alignment/Fluent.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::ros_interface {

/// What ~set_facts said is so in the robot's world. It changes the robot's state of the session
/// under way, or of the last one, which a goal may continue; and of later tasks whose models come
/// from parameters. A goal that brings its own robot problem says itself what is so. Thread-safe.
class RobotFacts {
 public:
  /// All of the facts are taken, or none: a fact that the robot's model of the session can't have,
  /// a name that is none, or a fact both true and false is refused with its index.
  session::Receipt set(const std::vector<Fluent>& facts);

  /// Changes when the facts of the session may have.
  unsigned version() const { return version_; }

  /// Another session begins. False: facts set before it do not hold for it.
  void beginSession(bool earlier_hold);

  /// What facts there can be in the session's robot model; until then none is refused as unknown.
  void setModel(const pddl::Model& model);

  /// The state changed by the facts that hold for the session; sorted. Facts that its model can't
  /// have are left out and named in `left_out`.
  std::vector<GroundName> overlaid(std::vector<GroundName> state,
                                   std::vector<GroundName>& left_out) const;

 private:
  using Changes = std::map<GroundName, bool>;

  std::atomic<unsigned> version_{1};
  mutable std::mutex mutex_;  // guards all below
  Changes all_;
  Changes session_;
  std::shared_ptr<const pddl::Model> model_;  // without its state
};

}  // namespace goal_alignment::ros_interface
