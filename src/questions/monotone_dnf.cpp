// SPDX-License-Identifier: BSD-3-Clause
#include "monotone_dnf.h"

#include <algorithm>

namespace goal_alignment::questions {

void addTo(DnfKey& key, CandidateMask set) {
  const std::uint64_t once = spread(set);
  key.low += once;
  key.high += spread(once ^ set);
}

void MonotoneDnf::add(CandidateMask set) {
  for (const CandidateMask other : sets_) {
    if ((other & ~set) == 0) return;
  }
  sets_.erase(std::remove_if(sets_.begin(), sets_.end(),
                             [set](CandidateMask other) { return (set & ~other) == 0; }),
              sets_.end());
  sets_.push_back(set);
}

MonotoneDnf MonotoneDnf::ifWanted(std::size_t candidate) const {
  const CandidateMask bit = maskOf(candidate);
  MonotoneDnf result;
  result.sets_.reserve(sets_.size());
  for (const CandidateMask set : sets_) {
    if (set == bit) return {};
    if ((set & bit) != 0) result.sets_.push_back(set & ~bit);
  }
  // No set that has shrunk contains another one that has; only the rest may contain one now.
  const std::size_t shrunk = result.sets_.size();
  for (const CandidateMask set : sets_) {
    if ((set & bit) != 0) continue;
    const auto end = result.sets_.begin() + static_cast<std::ptrdiff_t>(shrunk);
    if (std::none_of(result.sets_.begin(), end,
                     [set](CandidateMask s) { return (s & ~set) == 0; })) {
      result.sets_.push_back(set);
    }
  }
  return result;
}

MonotoneDnf MonotoneDnf::ifNotWanted(std::size_t candidate) const {
  MonotoneDnf result;
  result.sets_.reserve(sets_.size());
  for (const CandidateMask set : sets_) {
    if ((set & maskOf(candidate)) == 0) result.sets_.push_back(set);
  }
  return result;
}

CandidateMask MonotoneDnf::all() const {
  CandidateMask all = 0;
  for (const CandidateMask set : sets_)
    all |= set;
  return all;
}

DnfKey MonotoneDnf::key() const {
  DnfKey key;
  for (const CandidateMask set : sets_)
    addTo(key, set);
  return key;
}

}  // namespace goal_alignment::questions
