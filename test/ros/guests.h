// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/AlignGoal.h"

namespace goal_alignment::test {

/// Guests g0 … and one chair fewer, c0 …; the chair `spare` is broken, (free spare) mends it. The
/// person asks for g0 to be seated and seats all, since they believe that guests share chairs. So
/// the robot has to ask about g1 …, which it can't seat all. A few guests are no work,
/// twelve take seconds, kManyGuests the better part of a minute, all of it within one step.
AlignGoal seatGuests(int guests);

constexpr int kManyGuests = 150;

}  // namespace goal_alignment::test
