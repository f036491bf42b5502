// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace goal_alignment {

/// Finds numbered things by what they are, which their owner keeps: open addressing, with a part of
/// the hash beside the id, so that things are looked at nearly only when they are the same.
///
/// The table is cut into parts that grow one by one. To grow a table of millions in one go would
/// take longer than a cancel may wait.
class IdTable {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNone = static_cast<Id>(-1);

  /// The id with this hash for which `is_it(id)` holds, or kNone. Expected O(1).
  template <typename IsIt>
  Id find(std::uint64_t hash, IsIt&& is_it) const {
    if (parts_.empty()) return kNone;
    const std::vector<Slot>& slots = partOf(hash).slots;
    if (slots.empty()) return kNone;
    const std::size_t mask = slots.size() - 1;
    const std::uint32_t tag = tagOf(hash);
    for (std::size_t at = tag & mask; slots[at].id != kNone; at = (at + 1) & mask) {
      if (slots[at].tag == tag && is_it(slots[at].id)) return slots[at].id;
    }
    return kNone;
  }

  /// Enters an id that is not there yet. Expected O(1).
  void insert(std::uint64_t hash, Id id);

  /// Fetches the place that find() and insert() will look at first.
  void prefetch(std::uint64_t hash) const {
    if (parts_.empty()) return;
    const std::vector<Slot>& slots = partOf(hash).slots;
    if (!slots.empty()) __builtin_prefetch(&slots[tagOf(hash) & (slots.size() - 1)]);
  }

  std::size_t bytes() const { return slots_ * sizeof(Slot); }

 private:
  static constexpr std::size_t kParts = 64;

  struct Slot {
    Id id = kNone;  // kNone: free
    std::uint32_t tag = 0;
  };
  struct Part {
    std::vector<Slot> slots;  // none, or a power of two, at most half of them taken
    std::size_t taken = 0;
  };

  static std::uint32_t tagOf(std::uint64_t hash) { return static_cast<std::uint32_t>(hash); }
  const Part& partOf(std::uint64_t hash) const { return parts_[(hash >> 32U) % kParts]; }
  void grow(Part& part);

  std::vector<Part> parts_;  // none, or kParts
  std::size_t slots_ = 0;
};

}  // namespace goal_alignment
