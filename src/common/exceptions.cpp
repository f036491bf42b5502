// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/exceptions.h"

namespace goal_alignment {

LimitReached::LimitReached(LimitReason reason, const std::string& during)
    : Exception(during + " stopped: " + toString(reason)), reason_(reason) {}

}  // namespace goal_alignment
