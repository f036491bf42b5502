// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace goal_alignment::questions {

/// A set of up to 64 open candidates: bit i is candidate i.
using CandidateMask = std::uint64_t;

inline constexpr std::size_t kMaxCandidates = 64;

inline CandidateMask maskOf(std::size_t candidate) {
  return CandidateMask{1} << candidate;
}
inline std::size_t candidateCount(CandidateMask bits) {
  return static_cast<std::size_t>(__builtin_popcountll(bits));
}
/// The candidate of the lowest bit; the set must not be empty.
inline std::size_t firstCandidate(CandidateMask bits) {
  return static_cast<std::size_t>(__builtin_ctzll(bits));
}
/// for (CandidateMask left = set; left != 0; left = clearLowestBit(left)) … firstBit(left) …
inline CandidateMask clearLowestBit(CandidateMask bits) {
  return bits & (bits - 1);
}

/// Mixes the bits of a number: the finalizer of SplitMix64 (Steele, Lea & Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014).
inline std::uint64_t spread(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

/// Two DNFs are equal where their keys are, up to a chance of about 2^-100.
struct DnfKey {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  bool operator==(const DnfKey& other) const { return low == other.low && high == other.high; }
};

void addTo(DnfKey& key, CandidateMask set);

/// The state of a dialogue as the question that it has to answer: is all of one of these sets
/// wanted? No set is empty or a superset of another. Without sets the dialogue is over.
class MonotoneDnf {
 public:
  /// Adds a set unless it is a superset of one that is there; drops its supersets. O(sets).
  void add(CandidateMask set);

  /// What is left to answer after a YES: sets shrink, which may end the dialogue or make others
  /// superfluous. O(sets²) in the worst case.
  MonotoneDnf ifWanted(std::size_t candidate) const;
  /// What is left to answer after a NO: the sets with the candidate go. O(sets).
  MonotoneDnf ifNotWanted(std::size_t candidate) const;

  bool empty() const { return sets_.empty(); }
  std::size_t size() const { return sets_.size(); }
  auto begin() const { return sets_.begin(); }
  auto end() const { return sets_.end(); }

  /// All candidates in it.
  CandidateMask all() const;
  /// Independent of the sets' order.
  DnfKey key() const;

 private:
  std::vector<CandidateMask> sets_;
};

}  // namespace goal_alignment::questions
