// SPDX-License-Identifier: BSD-3-Clause
#include "outcome_entropy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "live_conflict.h"

namespace goal_alignment::questions {

namespace {

/// log P(no). Stays exact where all sets are very unlikely, unlike the product of 1 − P(S).
double logOfNo(const Family& family, const Chances& p) {
  double sum = 0;
  for (const Bits set : family) {
    double all = 1;
    for (Bits left = set; left != 0; left = withoutFirst(left))
      all *= p[firstBit(left)];
    sum += std::log1p(-all);
  }
  return sum;
}

double entropy(const Family& family, const Chances& p) {
  const double log_of_no = logOfNo(family, p);
  const double yes = -std::expm1(log_of_no);
  const double doubt_of_yes = yes > 0 ? -yes * std::log(yes) : 0;
  return doubt_of_yes - (yes < 1 ? (1 - yes) * log_of_no : 0);
}

}  // namespace

double chanceOfNo(const Family& family, const Chances& p) {
  return std::exp(logOfNo(family, p));
}

Bits leavingLeastDoubt(const Family& family, const Chances& p) {
  if (!(entropy(family, p) > 0)) return 0;
  double least = std::numeric_limits<double>::infinity();
  Bits result = 0;
  for (Bits left = family.all(); left != 0; left = withoutFirst(left)) {
    const std::size_t f = firstBit(left);
    const double doubt =
        p[f] * entropy(family.ifWanted(f), p) + (1 - p[f]) * entropy(family.ifNotWanted(f), p);
    if (doubt > least * (1 + kTolerance)) continue;
    if (doubt < least * (1 - kTolerance)) result = 0;
    least = std::min(least, doubt);
    result |= bitOf(f);
  }
  return result;
}

}  // namespace goal_alignment::questions
