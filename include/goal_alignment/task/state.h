// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "goal_alignment/task/task.h"

namespace goal_alignment::task {

using Word = std::uint64_t;
constexpr std::size_t kWordBits = 64;

/// Words that a bitset over `bits` things takes.
constexpr std::size_t wordsFor(std::size_t bits) {
  return (bits + kWordBits - 1) / kWordBits;
}

/// Bitset operations on raw words: states stand side by side in the registry, never as objects.
inline bool testBit(const Word* words, std::size_t bit) {
  return ((words[bit / kWordBits] >> (bit % kWordBits)) & 1U) != 0;
}
inline void setBit(Word* words, std::size_t bit) {
  words[bit / kWordBits] |= Word{1} << (bit % kWordBits);
}
inline void clearBit(Word* words, std::size_t bit) {
  words[bit / kWordBits] &= ~(Word{1} << (bit % kWordBits));
}

/// Calls visit(bit) for every set bit, in rising order. O(words + set bits).
template <typename Visit>
void forEachBit(const Word* words, std::size_t word_count, Visit&& visit) {
  for (std::size_t i = 0; i < word_count; ++i) {
    for (Word rest = words[i]; rest != 0; rest &= rest - 1) {
      visit(i * kWordBits + static_cast<std::size_t>(__builtin_ctzll(rest)));
    }
  }
}

/// A state of its own: the set of facts that are true.
using State = std::vector<Word>;

State initialState(const Task& task);

/// Whether all facts of the set are true in the state.
inline bool contains(const Word* state, const FactSet& facts) {
  for (const FactId fact : facts) {
    if (!testBit(state, fact)) return false;
  }
  return true;
}

/// Whether the state satisfies the goal.
inline bool satisfies(const Word* state, const Goal& goal) {
  for (const FactSet& alternative : goal.alternatives) {
    if (contains(state, alternative)) return true;
  }
  return false;
}

/// Writes the state after the operator into `successor` (which must not be `state`).
inline void apply(const Operator& op, const Word* state, std::size_t word_count, Word* successor) {
  for (std::size_t i = 0; i < word_count; ++i)
    successor[i] = state[i];
  for (const FactId fact : op.del)
    clearBit(successor, fact);
  if (!op.conditional.empty()) {
    for (const ConditionalEffect& effect : op.conditional) {
      if (!contains(state, effect.condition)) continue;
      for (const FactId fact : effect.del)
        clearBit(successor, fact);
    }
    for (const ConditionalEffect& effect : op.conditional) {
      if (!contains(state, effect.condition)) continue;
      for (const FactId fact : effect.add)
        setBit(successor, fact);
    }
  }
  for (const FactId fact : op.add)
    setBit(successor, fact);
}

}  // namespace goal_alignment::task
