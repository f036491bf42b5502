// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/short_vector.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace goal_alignment {
namespace {

using Short = ShortVector<int, 3>;

Short shortVector(const std::vector<int>& values) {
  Short result;
  for (const int value : values)
    result.push_back(value);
  return result;
}

bool holds(const Short& given, const std::vector<int>& values) {
  return given.size() == values.size() && std::equal(given.begin(), given.end(), values.begin());
}

RC_GTEST_PROP(ShortVector, HoldsWhatAVectorHolds, (std::vector<int> a, std::vector<int> b)) {
  Short first = shortVector(a);
  RC_ASSERT(holds(first, a));
  RC_ASSERT(first.empty() == a.empty());
  const Short copy = first;
  RC_ASSERT(copy == first);
  Short second = shortVector(b);
  RC_ASSERT((first == second) == (a == b));
  first = second;
  RC_ASSERT(holds(first, b) && holds(second, b) && holds(copy, a));
  const Short moved = std::move(second);
  RC_ASSERT(holds(moved, b));
  first.clear();
  first.push_back(1);
  RC_ASSERT(holds(first, {1}));
}

}  // namespace
}  // namespace goal_alignment
