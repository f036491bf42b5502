// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "pddl_text.h"

/// What a person may have wrong about the robot.
namespace goal_alignment::benchmarks {

/// In what the human's model differs from the robot's.
struct Misreading {
  bool actions = true;         ///< up to three preconditions and two deletes are not known
  bool initial_state = false;  ///< something is believed to be elsewhere
  bool statics = false;        ///< a static fact too many is believed
  bool vocabulary = false;     ///< a predicate and an object that only the human has
};

/// Letters `a`, `i`, `s`, `v` for the four; throws std::invalid_argument for any other.
Misreading misreadingOf(const std::string& letters);

/// The robot's models as such a person has them. Where there is nothing of a kind to get wrong
/// (nothing static, say), that kind is left as it is.
Models misread(const Models& robot, const Misreading& misreading, RandomSource& random);

/// Takes the literal out of the action's precondition; throws std::out_of_range where it isn't.
void forgetCondition(DomainParts& domain, const std::string& action, const std::string& literal);

/// Takes out the predicate and all that is said with it.
void forgetPredicate(Models& models, const std::string& name);

}  // namespace goal_alignment::benchmarks
