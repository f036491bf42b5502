// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::achievability {

enum class Verdict : std::uint8_t {
  Achievable,    ///< with a plan
  Unachievable,  ///< proven
  Unknown,       ///< a limit was reached; nothing is proven
};

/// The answer to "can these candidates be had together with the specified goal?".
struct Check {
  Verdict verdict = Verdict::Unknown;
  task::Plan plan;                        ///< with Achievable
  LimitReason limit = LimitReason::None;  ///< with Unknown
};

}  // namespace goal_alignment::achievability
