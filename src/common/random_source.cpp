// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/random_source.h"

namespace goal_alignment {

std::size_t RandomSource::below(std::size_t bound) {
  // Rejection keeps the draw uniform whatever the bound.
  const std::uint64_t n = bound;
  const std::uint64_t unusable = (0 - n) % n;
  for (;;) {
    const std::uint64_t draw = engine_();
    if (draw >= unusable) return static_cast<std::size_t>(draw % n);
  }
}

double RandomSource::unit() {
  return static_cast<double>(engine_() >> 11U) * 0x1.0p-53;
}

}  // namespace goal_alignment
