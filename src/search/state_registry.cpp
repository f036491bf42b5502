// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/state_registry.h"

#include <algorithm>

namespace goal_alignment::search {

using task::Word;

StateRegistry::StateRegistry(std::size_t words_per_state)
    : words_(std::max<std::size_t>(1, words_per_state)), table_(1024) {}

std::pair<StateId, bool> StateRegistry::insert(const Word* state, Hash hash) {
  if ((size_ + 1) * 2 > table_.size()) grow();
  const std::size_t mask = table_.size() - 1;
  const auto tag = static_cast<std::uint32_t>(hash >> 32U);
  std::size_t slot = hash & mask;
  for (; table_[slot].id != kNoState; slot = (slot + 1) & mask) {
    if (table_[slot].tag == tag && equals(state, table_[slot].id)) return {table_[slot].id, false};
  }
  const auto id = static_cast<StateId>(size_++);
  if ((id & kBlockMask) == 0) {
    blocks_.emplace_back(new Word[words_ << kBlockBits]);  // NOLINT: make_unique would clear it
  }
  std::copy_n(state, words_, blocks_.back().get() + (id & kBlockMask) * words_);
  table_[slot] = {id, tag};
  return {id, true};
}

void StateRegistry::grow() {
  table_.assign(table_.size() * 2, {});
  const std::size_t mask = table_.size() - 1;
  for (StateId id = 0; id < size_; ++id) {
    const Hash h = hash((*this)[id]);
    std::size_t slot = h & mask;
    while (table_[slot].id != kNoState)
      slot = (slot + 1) & mask;
    table_[slot] = {id, static_cast<std::uint32_t>(h >> 32U)};
  }
}

std::size_t StateRegistry::bytes() const {
  return blocks_.size() * (words_ << kBlockBits) * sizeof(Word) + table_.size() * sizeof(Slot);
}

}  // namespace goal_alignment::search
