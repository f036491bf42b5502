// SPDX-License-Identifier: BSD-3-Clause
#include "paper_policy.h"

#include <algorithm>
#include <cmath>

#include "goal_alignment/common/random_source.h"
#include "live_conflict.h"

namespace goal_alignment::questions {

std::vector<double> valueOfQuery(const std::vector<double>& belief,
                                 const std::vector<bool>& unachievable_alone) {
  std::vector<double> value(belief.size());
  for (std::size_t f = 0; f < belief.size(); ++f) {
    double all_wanted = 1;     // Π over F̂
    double others_wanted = 1;  // Π over F̂ \ {f}
    for (std::size_t g = 0; g < belief.size(); ++g) {
      if (!unachievable_alone[g]) continue;
      all_wanted *= belief[g];
      if (g != f) others_wanted *= belief[g];
    }
    const double if_wanted = unachievable_alone[f] ? 1 : all_wanted;
    value[f] = belief[f] * if_wanted + (1 - belief[f]) * others_wanted;
  }
  return value;
}

void PaperPolicy::fillQueue() {
  queue_filled_ = true;
  const std::vector<bool> unachievable = context_.unachievable_alone();
  // With an empty F̂ every value is 1 whatever the beliefs are, so they need not be computed.
  const bool all_equal =
      std::none_of(unachievable.begin(), unachievable.end(), [](bool b) { return b; });
  const std::vector<double> value = all_equal
                                        ? std::vector<double>(unachievable.size(), 1)
                                        : valueOfQuery(context_.paper_beliefs(), unachievable);
  for (std::size_t f = 0; f < value.size(); ++f) {
    if (context_.ask_static || !context_.is_static[f]) queue_.push_back(f);
  }
  RandomSource random(context_.seed);
  for (std::size_t i = queue_.size(); i > 1; --i)
    std::swap(queue_[i - 1], queue_[random.below(i)]);
  std::stable_sort(queue_.begin(), queue_.end(), [&](std::size_t a, std::size_t b) {
    return std::round(value[a] / kTolerance) < std::round(value[b] / kTolerance);
  });
}

std::optional<Choice> PaperPolicy::next(const Situation& situation) {
  if (!queue_filled_) fillQueue();
  // Nothing is taken off the queue: what was answered "don't know" may become open once more.
  const auto first = std::find_if(queue_.rbegin(), queue_.rend(), [&](std::size_t f) {
    return situation.knowledge[f] == Knowledge::Open;
  });
  if (first == queue_.rend()) return std::nullopt;
  return Choice{*first, smallestLiveConflict(situation, *first)};
}

}  // namespace goal_alignment::questions
