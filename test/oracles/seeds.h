// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rapidcheck.h>

#include <cstdint>

#include "goal_alignment/common/random_source.h"

namespace goal_alignment::oracles {

/// A seed for the random tasks and problems here. RapidCheck draws and prints it, so that a failing
/// case can be had again; it is not shrunk, since a smaller seed is no simpler task.
inline RandomSource anySource() {
  const auto seed = rc::gen::noShrink(rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>()));
  return RandomSource(*seed);
}

/// True with the probability.
inline bool chance(RandomSource& random, double probability) {
  return random.unit() < probability;
}

/// Uniform in [least, most].
inline std::size_t between(RandomSource& random, std::size_t least, std::size_t most) {
  return least + random.below(most - least + 1);
}

}  // namespace goal_alignment::oracles
