// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::execution {

/// What is so in the robot's world: what is in neither list is false.
struct WorldState {
  std::vector<GroundName> facts;
  std::vector<GroundName> unknown;
};

/// Holds the robot's model against its world: may an action begin, and what has it changed? Knows
/// nothing of ROS. Not thread-safe.
class RobotWatch {
 public:
  enum class Verdict {
    Holds,
    False,
    Unknown,  ///< it depends on atoms that are unknown
    NoModel   ///< this model is not that of the plan or of the state: it can't be told
  };
  struct Finding {
    Verdict verdict = Verdict::Holds;
    std::string reason;  ///< one sentence, but for Holds
  };

  explicit RobotWatch(pddl::Model model) : model_(std::move(model)) {}

  /// Whether the action's precondition holds. O(state + size of the precondition).
  Finding precondition(const GroundName& action, const WorldState& world);

  /// Whether all of the literals hold.
  Finding literals(const std::vector<Literal>& wanted, const WorldState& world) const;

  /// What changes when the action is carried out in that state; nothing where it can't be.
  std::vector<Literal> effects(const GroundName& action, const WorldState& world);

 private:
  // False: the model does not know an atom, which `stranger` then names.
  bool setState(const WorldState& world, bool unknown_hold, std::string& stranger);

  pddl::Model model_;  // its init is the state looked at last
};

}  // namespace goal_alignment::execution
