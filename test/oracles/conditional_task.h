// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/task/task.h"
#include "oracles/random_task.h"
#include "oracles/state_space.h"

namespace goal_alignment::oracles {

/// A random task some of whose operators have up to two conditional effects.
task::Task randomConditionalTask(RandomSource& random, const TaskSize& size = {});

/// The reachable states of a task that may have conditional effects, by their definition.
std::set<Facts> conditionallyReachable(const task::Task& task);

}  // namespace goal_alignment::oracles
