// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace goal_alignment {

/// Seeded random numbers that are the same on every platform: the standard's distributions are
/// not, so the mapping from the engine's output is ours.
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, bound); bound must be positive.
  std::size_t below(std::size_t bound);
  /// Uniform in [0, 1).
  double unit();

 private:
  std::mt19937_64 engine_;
};

}  // namespace goal_alignment
