// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::execution {

/// What is so in the robot's world: what is in neither list is false.
struct WorldState {
  std::vector<GroundName> facts;
  std::vector<GroundName> unknown;

  /// These are so now. Keeps lists that are sorted so.
  void apply(const std::vector<Literal>& changes);

  friend bool operator==(const WorldState& a, const WorldState& b) {
    return a.facts == b.facts && a.unknown == b.unknown;
  }
};

/// Holds the robot's model against its world: may an action begin, can those after it, and what
/// has it changed? Knows nothing of ROS. Not thread-safe.
class PreconditionMonitor {
 public:
  enum class Verdict {
    Holds,
    False,
    Unknown,  ///< it depends on atoms that are unknown
    NoModel   ///< this model is not that of the plan or of the state: it can't be told
  };
  struct Finding {
    Verdict verdict = Verdict::Holds;
    std::string reason;    ///< one sentence, but for Holds
    std::size_t step = 0;  ///< of rest(): which one can't be carried out; behind the last: the end
  };

  explicit PreconditionMonitor(pddl::Model model) : model_(std::move(model)) {}

  /// Whether the action's precondition holds. O(state + size of the precondition).
  Finding precondition(const GroundName& action, const WorldState& world);

  /// Whether all of the literals hold.
  Finding literals(const std::vector<Literal>& wanted, const WorldState& world) const;

  /// Whether the steps can be carried out one after the other, and the literals hold at the end:
  /// False or Holds. Unknown atoms are believed to be as the steps need them.
  /// O((state + steps · effects) · (1 + unknown atoms that the steps need)).
  Finding rest(const std::vector<GroundName>& steps, const std::vector<Literal>& wanted,
               const WorldState& world);

  /// What changes when the action is carried out in that state; nothing where it can't be.
  std::vector<Literal> effects(const GroundName& action, const WorldState& world);

  /// What is so after the action in whatever state it was carried out.
  std::vector<Literal> certainEffects(const GroundName& action) const;

  const pddl::Model& model() const { return model_; }

 private:
  Finding tryRest(const std::vector<GroundName>& steps, const std::vector<Literal>& wanted,
                  const WorldState& world, bool unknown_hold);
  // False: the model does not know an atom, which `stranger` then names.
  bool setState(const WorldState& world, bool unknown_hold, std::string& stranger);

  pddl::Model model_;  // its init is the state looked at last
};

}  // namespace goal_alignment::execution
