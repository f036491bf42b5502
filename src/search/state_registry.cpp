// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/search/state_registry.h"

#include <algorithm>

namespace goal_alignment::search {

using task::Word;

StateRegistry::StateRegistry(std::size_t words_per_state)
    : words_(std::max<std::size_t>(1, words_per_state)) {}

std::pair<StateId, bool> StateRegistry::insert(const Word* state, Hash hash) {
  const StateId known = table_.find(hash, [&](StateId id) { return equals(state, id); });
  if (known != kNoState) return {known, false};
  const auto id = static_cast<StateId>(size_++);
  if ((id & kBlockMask) == 0) {
    blocks_.emplace_back(new Word[words_ << kBlockBits]);  // NOLINT: make_unique would clear it
  }
  std::copy_n(state, words_, blocks_.back().get() + (id & kBlockMask) * words_);
  table_.insert(hash, id);
  return {id, true};
}

std::size_t StateRegistry::bytes() const {
  return blocks_.size() * (words_ << kBlockBits) * sizeof(Word) + table_.bytes();
}

}  // namespace goal_alignment::search
