// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/pddl/source_position.h"

namespace goal_alignment::pddl {

/// A domain as somebody knows it who has forgotten some of it.
struct Perturbation {
  std::string text;  ///< what is left; it stands as it stood, comments and all
  /// "precondition (free ?b) of pick-up", "delete (not (free ?b)) of pick-up", in the text's order.
  std::vector<std::string> forgotten;
};

/// Takes `preconditions` conjuncts of preconditions and `deletes` delete effects, conditional ones
/// too, out of the actions of a domain; all are equally likely. That is how human models are made
/// in the evaluation of Mechergui & Sreedharan, "Goal Alignment", section "Evaluation".
///
/// Throws what parseDomain() and checkDomain() do, and std::invalid_argument where the domain has
/// fewer of them. What is left is a domain again: preconditions stay without which it would be
/// none. O(text · preconditions).
Perturbation perturb(const Source& domain, std::size_t preconditions, std::size_t deletes,
                     RandomSource& random);

}  // namespace goal_alignment::pddl
