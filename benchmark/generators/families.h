// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "pddl_text.h"

/// Families of planning tasks. `size` counts what the family's comment says; the draws come from
/// `random` alone, so that a seed makes one text.
namespace goal_alignment::benchmarks {

/// Crates in piles, to be piled up anew by one crane. size: crates.
Models crates(int size, RandomSource& random);

/// Parcels between the stops of several towns; vans within a town, planes between. size: parcels.
Models parcels(int size, RandomSource& random);

/// Passengers and lifts that carry two at most. size: passengers.
Models lifts(int size, RandomSource& random);

/// Probes that take samples on a map, examine them in the one tray they have, and report from where
/// the base is in sight. size: samples.
Models probes(int size, RandomSource& random);

/// One ring more than there are pegs, all to hang at once: no plan, and only counting shows it.
/// size: pegs.
Models pegs(int size, RandomSource& random);

/// A courier in the middle of three streets of `size` houses has to call at the last house of each,
/// with charge for all the way but one step: no plan, as the charge runs out. `spare` adds charge;
/// with 1 there is a plan.
Models courier(int size, int spare);

/// Twice as many guests as chairs; a guest may give their chair to a friend. One guest more than
/// there are chairs is to sit: no plan, by counting within a part of the objects. size: chairs, at
/// least 2.
Models guests(int size, RandomSource& random);

/// Items that a trolley takes along, fragile ones only as the first: formulas, quantified and
/// conditional effects. size: items.
Models trolley(int size, RandomSource& random);

/// A household of dishes.
struct HouseholdSize {
  int rooms = 3;
  int cupboards = 3;
  int stands = 4;  ///< surfaces for one dish each
  int dishes = 8;
  int laid = 2;  ///< dishes that the goal wants out on some stand
};

/// Rooms joined by doors; cupboards that must be open, stands for one dish, some of either too high
/// for this robot; some dishes too heavy for it; two hands. The goal: dishes out on stands, their
/// cupboards shut again. size: dishes.
Models household(const HouseholdSize& size, RandomSource& random);
Models household(int size, RandomSource& random);

/// A home in the domain of config/domains/home, see home.h. size: things that lie about.
Models home(int size, RandomSource& random);

struct MonotoneDnf {
  std::string name;
  Models (*make)(int size, RandomSource& random);
  bool solvable = true;
  std::vector<int> sizes;  ///< from what takes no time to what takes long
  bool formulas = false;   ///< its domain has more than literals, so that it can't be misread
};

const std::vector<MonotoneDnf>& families();

/// Throws std::invalid_argument, which names the families there are.
const MonotoneDnf& familyCalled(const std::string& name);

}  // namespace goal_alignment::benchmarks
