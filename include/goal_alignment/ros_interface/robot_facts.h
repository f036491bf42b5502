// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "goal_alignment/Fluent.h"
#include "goal_alignment/GetFacts.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::ros_interface {

/// What is so in the robot's world: the problem file of the session under way, or of the last one,
/// which a goal may continue, changed by what ~set_facts said. Facts that were set also hold for
/// later tasks whose models come from parameters; a goal that brings its own robot problem says
/// itself what is so. Thread-safe.
class RobotFacts {
 public:
  /// All of the facts are taken, or none: a fact that the robot's model of the session can't have,
  /// a name that is none, or a fact both true and false is refused with its index.
  session::Receipt set(const std::vector<Fluent>& facts);

  /// Changes when the facts of the session may have.
  unsigned version() const { return version_; }

  /// Another session begins. `earlier_hold` false: facts set before it do not hold for it.
  void beginSession(const std::string& session_id, bool earlier_hold);

  /// What facts there can be in the session's robot model, and those of its problem file; until
  /// then none is refused as unknown.
  void setModel(const pddl::Model& model);

  /// All atoms that are true now; sorted. Facts that were set and that the model can't have are
  /// left out and named in `left_out`. Needs the model.
  std::vector<GroundName> state(std::vector<GroundName>& left_out) const;

  /// The answer of ~get_facts. Never waits for the solver thread.
  GetFacts::Response tell() const;

 private:
  using Changes = std::map<GroundName, bool>;

  // What holds for one session.
  struct World {
    std::string session_id;  // empty: no task yet
    Changes set;
    std::shared_ptr<const pddl::Model> model;  // null: not read yet
  };

  World world() const;
  static std::vector<GroundName> stateOf(const World& world, std::vector<GroundName>& left_out);

  std::atomic<unsigned> version_{1};
  mutable std::mutex mutex_;  // guards all below
  Changes all_;
  World world_;
};

}  // namespace goal_alignment::ros_interface
