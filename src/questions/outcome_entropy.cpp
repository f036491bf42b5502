// SPDX-License-Identifier: BSD-3-Clause
#include "outcome_entropy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "live_conflict.h"

namespace goal_alignment::questions {

namespace {

/// log P(no). Stays exact where all sets are very unlikely, unlike the product of 1 − P(S).
double logOfNo(const MonotoneDnf& dnf, const Chances& p) {
  double sum = 0;
  for (const CandidateMask set : dnf) {
    double all = 1;
    for (CandidateMask left = set; left != 0; left = clearLowestBit(left))
      all *= p[firstCandidate(left)];
    sum += std::log1p(-all);
  }
  return sum;
}

double entropy(const MonotoneDnf& dnf, const Chances& p) {
  const double log_of_no = logOfNo(dnf, p);
  const double yes = -std::expm1(log_of_no);
  const double entropy_of_yes = yes > 0 ? -yes * std::log(yes) : 0;
  return entropy_of_yes - (yes < 1 ? (1 - yes) * log_of_no : 0);
}

}  // namespace

double chanceOfNo(const MonotoneDnf& dnf, const Chances& p) {
  return std::exp(logOfNo(dnf, p));
}

CandidateMask mostInformative(const MonotoneDnf& dnf, const Chances& p) {
  if (!(entropy(dnf, p) > 0)) return 0;
  double lowest = std::numeric_limits<double>::infinity();
  CandidateMask result = 0;
  for (CandidateMask left = dnf.all(); left != 0; left = clearLowestBit(left)) {
    const std::size_t f = firstCandidate(left);
    const double expected =
        p[f] * entropy(dnf.ifWanted(f), p) + (1 - p[f]) * entropy(dnf.ifNotWanted(f), p);
    if (expected > lowest * (1 + kTolerance)) continue;
    if (expected < lowest * (1 - kTolerance)) result = 0;
    lowest = std::min(lowest, expected);
    result |= maskOf(f);
  }
  return result;
}

}  // namespace goal_alignment::questions
