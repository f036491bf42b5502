// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/AlignGoal.h"

/// Tasks whose models are generated texts: as many questions, or as much work, as a scenario needs.
/// The texts are those of benchmark/generators/dialogue_tasks.h.
namespace goal_alignment::test {

/// Like sweepBothRooms() with so many rooms, each of which is asked about.
AlignGoal sweepRooms(int rooms);

/// So many guests, and one chair fewer; ten of them take a while.
AlignGoal seatGuests(int guests);

/// Models of many megabytes; nothing about them is hard.
AlignGoal longToRead(int rooms = 200'000);
/// Few objects, but 10^9 ground actions.
AlignGoal longToGround();
/// A sliding puzzle with two tiles swapped: it takes ages to find out that it can't be solved.
AlignGoal longToAnalyse();
/// A plan is found at once, and with the parameter plan: optimal a shortest one takes ages.
AlignGoal longToPlan();

}  // namespace goal_alignment::test
