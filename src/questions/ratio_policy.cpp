// SPDX-License-Identifier: BSD-3-Clause
#include "ratio_policy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "live_conflict.h"

namespace goal_alignment::questions {

namespace {

/// log(P/E) of a conflict whose open members have these probabilities: a product of many small ones
/// would underflow. Minus infinity where one of them is 0.
double logRatio(std::vector<double> probability) {
  std::sort(probability.begin(), probability.end());
  double log_all = 0;
  double cost = 0;
  double reached = 1;  // P(a question is reached): all before it were answered YES
  for (const double p : probability) {
    cost += reached;
    reached *= p;
    log_all += std::log(p);
  }
  return log_all - std::log(cost);
}

bool nearlyEqual(double a, double b) {
  return a == b || std::abs(a - b) <= kTolerance * std::max(1.0, std::abs(a));
}

/// The least likely members of the live conflicts with the highest ratio.
std::vector<std::size_t> leastLikelyInBestConflicts(const std::vector<LiveConflict>& live,
                                                    const std::vector<double>& probability) {
  double best = -std::numeric_limits<double>::infinity();
  std::set<std::size_t> chosen;
  for (const LiveConflict& conflict : live) {
    std::vector<double> of_members;
    for (const std::size_t f : conflict.open)
      of_members.push_back(probability[f]);
    const double lowest = *std::min_element(of_members.begin(), of_members.end());
    const double ratio = logRatio(std::move(of_members));
    if (ratio < best && !nearlyEqual(ratio, best)) continue;
    if (!nearlyEqual(ratio, best)) chosen.clear();
    best = std::max(best, ratio);
    for (const std::size_t f : conflict.open) {
      if (probability[f] <= lowest + kTolerance * lowest) chosen.insert(f);
    }
  }
  return {chosen.begin(), chosen.end()};
}

/// The candidates in the most live conflicts, all of which one NO settles.
std::vector<std::size_t> inMostConflicts(const std::vector<LiveConflict>& live,
                                         std::size_t candidates,
                                         const std::vector<std::size_t>& among) {
  std::vector<std::size_t> degree(candidates);
  for (const LiveConflict& conflict : live) {
    for (const std::size_t f : conflict.open)
      ++degree[f];
  }
  std::size_t max_degree = 0;
  for (const std::size_t f : among)
    max_degree = std::max(max_degree, degree[f]);
  std::vector<std::size_t> result;
  std::copy_if(among.begin(), among.end(), std::back_inserter(result),
               [&](std::size_t f) { return degree[f] == max_degree; });
  return result;
}

}  // namespace

std::optional<Choice> RatioPolicy::next(const Situation& situation) {
  const std::vector<LiveConflict> live = liveConflicts(situation);
  if (live.empty()) return std::nullopt;
  const auto least_likely = leastLikelyInBestConflicts(live, situation.probability);
  return chooseAmong(inMostConflicts(live, situation.knowledge.size(), least_likely), situation,
                     random_);
}

}  // namespace goal_alignment::questions
