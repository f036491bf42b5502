// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "goal_alignment/common/random_source.h"

namespace goal_alignment::benchmarks {

/// One of them, which must not be none.
template <typename T>
const T& oneOf(const std::vector<T>& values, RandomSource& random) {
  return values[random.below(values.size())];
}

/// The same values in any order (Fisher and Yates).
template <typename T>
std::vector<T> shuffled(std::vector<T> values, RandomSource& random) {
  for (std::size_t left = values.size(); left > 1; --left)
    std::swap(values[left - 1], values[random.below(left)]);
  return values;
}

}  // namespace goal_alignment::benchmarks
