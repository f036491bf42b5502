// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::oracles {

struct TaskSize {
  std::size_t least_facts = 4;
  std::size_t most_facts = 8;
  std::size_t least_operators = 3;
  std::size_t most_operators = 10;
  task::Cost most_cost = 3;  ///< costs are drawn from 0 to this
  task::Cost least_cost = 0;
  bool conditional = true;  ///< some operators have conditional effects
};

/// A random grounded task: up to three preconditions, one or two adds, up to two deletes. Some
/// operators need nothing, some cost nothing, some have conditional effects.
task::Task randomTask(RandomSource& random, const TaskSize& size = {});

/// One to three facts, seldom true at first.
task::FactSet randomGoal(RandomSource& random, const task::Task& task);

/// One to three of these.
task::Goal randomAlternatives(RandomSource& random, const task::Task& task);

}  // namespace goal_alignment::oracles
