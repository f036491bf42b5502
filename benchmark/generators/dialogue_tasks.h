// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/session/session.h"

/// Alignments made for what happens while they are worked on: as many questions, or as much work in
/// one phase, as is needed.
namespace goal_alignment::benchmarks {

/// The person wants rooms r0 … swept and doesn't know that sweeping ends their being quiet: each
/// (quiet r) has to be asked about.
session::Input sweptRooms(int rooms);

/// Guests g0 … and one chair fewer, c0 …; the chair `spare` is broken, (free spare) mends it. The
/// person asks for g0 to be seated and seats all, since they believe that guests share chairs. So
/// the robot has to ask about g1 …, which it can't seat all.
session::Input seatedGuests(int guests);

/// Models of many megabytes, of which nothing is hard: reading.
session::Input longText(int rooms);

/// An action over all six-tuples of rooms, all of them reachable: grounding.
session::Input wideAction(int rooms);

/// A sliding puzzle, of which the person believes that two tiles can change places: then all others
/// stay where they are. For the robot one half of all orders is out of reach, which no part of an
/// order shows. On a side of four it takes ages to find that out: the analysis.
session::Input swappedTiles(int side);

/// Models that agree: nothing to ask, a plan at once, but a long way to the optimal one.
session::Input carriedBalls(int balls);

}  // namespace goal_alignment::benchmarks
