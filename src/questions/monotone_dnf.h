// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace goal_alignment::questions {

/// A set of up to 64 open candidates, one a bit.
using CandidateMask = std::uint64_t;

inline constexpr std::size_t kMaxBits = 64;

inline CandidateMask bitOf(std::size_t candidate) {
  return CandidateMask{1} << candidate;
}
inline std::size_t countBits(CandidateMask bits) {
  return static_cast<std::size_t>(__builtin_popcountll(bits));
}
/// The lowest bit's index; there must be one.
inline std::size_t firstBit(CandidateMask bits) {
  return static_cast<std::size_t>(__builtin_ctzll(bits));
}
/// for (CandidateMask left = set; left != 0; left = clearLowestBit(left)) … firstBit(left) …
inline CandidateMask clearLowestBit(CandidateMask bits) {
  return bits & (bits - 1);
}

/// Spreads a number over 64 bits, as if by chance (Steele, Lea & Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014).
inline std::uint64_t spread(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

/// What makes two DNFs the same one, up to a chance of 2^-100.
struct DnfKey {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  bool operator==(const DnfKey& other) const { return low == other.low && high == other.high; }
};

void addTo(DnfKey& key, CandidateMask set);

/// The state of a dialogue: is one of these sets all wanted? None of them is empty or within
/// another. No set at all: the dialogue is over.
class MonotoneDnf {
 public:
  /// Adds a set, unless one within it is there; drops those that it is within. O(sets).
  void add(CandidateMask set);

  /// After YES: sets shrink, which may end it or make others superfluous. O(sets²) at worst.
  MonotoneDnf ifWanted(std::size_t candidate) const;
  /// After NO: sets go. O(sets).
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
