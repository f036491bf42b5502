// SPDX-License-Identifier: BSD-3-Clause
#include "optimal_policy.h"

#include <algorithm>

namespace goal_alignment::questions {

std::optional<Choice> OptimalPolicy::next(const Situation& situation) {
  const std::vector<LiveConflict> live = liveConflicts(situation);
  if (live.empty()) return std::nullopt;
  if (!giveBits(live, situation)) return ratio_.next(situation);
  const std::optional<Bits> first = cost_->bestFirst(familyOf(live), work_);
  if (!first) return ratio_.next(situation);
  std::vector<std::size_t> candidates;
  for (Bits left = *first; left != 0; left = withoutFirst(left))
    candidates.push_back(candidate_of_[firstBit(left)]);
  return anyOf(candidates, situation, random_);
}

/// False where there are more candidates than bits. Begins anew where the bits are used up or where
/// a probability is another one.
bool OptimalPolicy::giveBits(const std::vector<LiveConflict>& live, const Situation& situation) {
  std::map<std::size_t, std::size_t> wanted;
  bool fits = cost_.has_value();
  for (const LiveConflict& conflict : live) {
    for (const std::size_t f : conflict.open) {
      const auto known = bit_of_.find(f);
      fits = fits && known != bit_of_.end() &&
             probability_of_[known->second] == situation.probability[f];
      wanted.emplace(f, 0);
    }
  }
  if (fits) return true;
  if (wanted.size() > kMostBits) return false;
  Chances chances{};
  candidate_of_.clear();
  for (auto& [f, bit] : wanted) {
    bit = candidate_of_.size();
    chances[bit] = situation.probability[f];
    candidate_of_.push_back(f);
  }
  probability_of_.assign(chances.begin(), chances.end());
  bit_of_ = std::move(wanted);
  cost_.emplace(chances);
  return true;
}

Family OptimalPolicy::familyOf(const std::vector<LiveConflict>& live) const {
  Family family;
  for (const LiveConflict& conflict : live) {
    Bits set = 0;
    for (const std::size_t f : conflict.open)
      set |= bitOf(bit_of_.at(f));
    family.add(set);
  }
  return family;
}

}  // namespace goal_alignment::questions
