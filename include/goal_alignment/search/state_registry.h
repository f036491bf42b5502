// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "goal_alignment/common/id_table.h"
#include "goal_alignment/task/state.h"

namespace goal_alignment::search {

using StateId = std::uint32_t;
constexpr StateId kNoState = static_cast<StateId>(-1);

/// Every state once, numbered in the order of insertion. The states' words stand in blocks that
/// never move; a table of ids finds them again.
class StateRegistry {
 public:
  explicit StateRegistry(std::size_t words_per_state);

  using Hash = std::uint64_t;

  Hash hash(const task::Word* state) const {
    Hash h = 0x9e3779b97f4a7c15ULL;
    for (std::size_t i = 0; i < words_; ++i) {
      h = (h ^ state[i]) * 0xbf58476d1ce4e5b9ULL;
      h ^= h >> 29U;
    }
    return h ^ (h >> 32U);
  }

  /// Fetches the place in the table that insert() will look at first: worth while where a batch of
  /// states is hashed before any of them is inserted.
  void prefetch(Hash hash) const { table_.prefetch(hash); }

  /// The state's id, and whether it is new. Expected O(words).
  std::pair<StateId, bool> insert(const task::Word* state) { return insert(state, hash(state)); }
  std::pair<StateId, bool> insert(const task::Word* state, Hash hash);

  const task::Word* operator[](StateId id) const {
    return blocks_[id >> kBlockBits].get() + (id & kBlockMask) * words_;
  }
  std::size_t size() const { return size_; }
  std::size_t words() const { return words_; }
  /// Accounted bytes of states and table.
  std::size_t bytes() const;

 private:
  static constexpr unsigned kBlockBits = 12;
  static constexpr StateId kBlockMask = (1U << kBlockBits) - 1;

  bool equals(const task::Word* state, StateId id) const {
    const task::Word* other = (*this)[id];
    for (std::size_t i = 0; i < words_; ++i) {
      if (state[i] != other[i]) return false;
    }
    return true;
  }

  std::size_t words_;
  std::size_t size_ = 0;
  std::vector<std::unique_ptr<task::Word[]>> blocks_;
  IdTable table_;
};

}  // namespace goal_alignment::search
