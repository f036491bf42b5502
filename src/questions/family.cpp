// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"

#include <algorithm>

namespace goal_alignment::questions {

void addTo(FamilyKey& key, Bits set) {
  const std::uint64_t once = spread(set);
  key.low += once;
  key.high += spread(once ^ set);
}

void Family::add(Bits set) {
  for (const Bits other : sets_) {
    if ((other & ~set) == 0) return;
  }
  sets_.erase(
      std::remove_if(sets_.begin(), sets_.end(), [set](Bits other) { return (set & ~other) == 0; }),
      sets_.end());
  sets_.push_back(set);
}

Family Family::ifWanted(std::size_t candidate) const {
  const Bits bit = bitOf(candidate);
  Family result;
  result.sets_.reserve(sets_.size());
  for (const Bits set : sets_) {
    if (set == bit) return {};
    if ((set & bit) != 0) result.sets_.push_back(set & ~bit);
  }
  // What has shrunk stays without one another; only the rest may have come to hold one of it.
  const std::size_t shrunk = result.sets_.size();
  for (const Bits set : sets_) {
    if ((set & bit) != 0) continue;
    const auto end = result.sets_.begin() + static_cast<std::ptrdiff_t>(shrunk);
    if (std::none_of(result.sets_.begin(), end, [set](Bits s) { return (s & ~set) == 0; })) {
      result.sets_.push_back(set);
    }
  }
  return result;
}

Family Family::ifNotWanted(std::size_t candidate) const {
  Family result;
  result.sets_.reserve(sets_.size());
  for (const Bits set : sets_) {
    if ((set & bitOf(candidate)) == 0) result.sets_.push_back(set);
  }
  return result;
}

Bits Family::all() const {
  Bits all = 0;
  for (const Bits set : sets_)
    all |= set;
  return all;
}

FamilyKey Family::key() const {
  FamilyKey key;
  for (const Bits set : sets_)
    addTo(key, set);
  return key;
}

}  // namespace goal_alignment::questions
