// SPDX-License-Identifier: BSD-3-Clause
#include "optimal_policy.h"

#include <set>
#include <utility>

#include "outcome_entropy.h"

namespace goal_alignment::questions {

namespace {

/// From this P(no) on entropy is a better guide than P/E: on random DNFs of 30 candidates, each
/// wanted with a chance of 0.02 to 0.22, it asks 4 % fewer questions; below, it asks as many or
/// more (benchmark/questions_benchmark.cpp).
constexpr double kMinChanceOfNo = 0.3;

}  // namespace

std::optional<Choice> OptimalPolicy::next(const Situation& situation) {
  const std::vector<LiveConflict> live = liveConflicts(situation);
  if (live.empty()) return std::nullopt;
  if (!assignBits(live, situation)) return ratio_.next(situation);
  const MonotoneDnf dnf = dnfOf(live);
  const CandidateMask first = cost_->bestFirst(dnf, work_).value_or(0);
  if (first != 0) return choiceOf(first, situation);
  if (chanceOfNo(dnf, cost_->chances()) < kMinChanceOfNo) return ratio_.next(situation);
  const CandidateMask informative = mostInformative(dnf, cost_->chances());
  return informative != 0 ? choiceOf(informative, situation) : ratio_.next(situation);
}

Choice OptimalPolicy::choiceOf(CandidateMask set, const Situation& situation) {
  std::vector<std::size_t> candidates;
  for (CandidateMask left = set; left != 0; left = clearLowestBit(left))
    candidates.push_back(candidate_of_[firstCandidate(left)]);
  return chooseAmong(candidates, situation, random_);
}

/// Returns false where there are more candidates than bits. Assigns all bits anew where a candidate
/// has none yet or its probability has changed since it got one.
bool OptimalPolicy::assignBits(const std::vector<LiveConflict>& live, const Situation& situation) {
  std::set<std::pair<double, std::size_t>> rising;
  bool fits = cost_.has_value();
  for (const LiveConflict& conflict : live) {
    for (const std::size_t f : conflict.open) {
      rising.emplace(situation.probability[f], f);
      const auto known = bit_of_.find(f);
      fits = fits && known != bit_of_.end() &&
             cost_->chances()[known->second] == situation.probability[f];
    }
  }
  if (fits) return true;
  if (rising.size() > kMaxCandidates) return false;
  candidate_of_.clear();
  bit_of_.clear();
  std::vector<double> chances;
  for (const auto& [probability, f] : rising) {
    bit_of_.emplace(f, candidate_of_.size());
    candidate_of_.push_back(f);
    chances.push_back(probability);
  }
  cost_.emplace(Chances(chances), poll_);
  return true;
}

MonotoneDnf OptimalPolicy::dnfOf(const std::vector<LiveConflict>& live) const {
  MonotoneDnf dnf;
  for (const LiveConflict& conflict : live) {
    CandidateMask set = 0;
    for (const std::size_t f : conflict.open)
      set |= maskOf(bit_of_.at(f));
    dnf.add(set);
  }
  return dnf;
}

}  // namespace goal_alignment::questions
