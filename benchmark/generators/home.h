// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/random_source.h"
#include "pddl_text.h"

namespace goal_alignment::benchmarks {

/// A home in the domains of config/domains/home, larger than its tasks: dishes and laundry lie
/// about in the rooms of several floors, some on top of a cupboard. All dishes are to be washed and
/// put away, all laundry to be washed and hung up, as far as the robot gets at it.
struct Home {
  Models robot;
  Models human;                        ///< some dishes are not where the person believes
  std::vector<GroundName> human_plan;  ///< gathers everything, from upstairs and high up, too
};

/// `size`: things that lie about, at least 1. Throws pddl::InputError where the domains can't be
/// read.
Home drawnHome(int size, RandomSource& random);

}  // namespace goal_alignment::benchmarks
