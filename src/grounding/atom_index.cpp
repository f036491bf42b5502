// SPDX-License-Identifier: BSD-3-Clause
#include "atom_index.h"

#include <algorithm>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::grounding {

namespace {

constexpr std::size_t kMaxPositions = 64;
/// Joins ask for few sets of positions; texts that ask for many pay with time, not with memory.
constexpr std::size_t kMaxIndices = 16;

/// The arguments at the positions, as an atom's.
void project(const pddl::AtomView& atom, std::uint64_t positions, pddl::Atom& key) {
  key.objects.clear();
  for (std::size_t i = 0; i < std::min(atom.objects.size(), kMaxPositions); ++i) {
    if (((positions >> i) & 1U) != 0) key.objects.push_back(atom.objects[i]);
  }
}

}  // namespace

void AtomIndex::insert(AtomId id) {
  const auto p = static_cast<std::size_t>(atoms_[id].predicate);
  all_[p].push_back(id);
  for (const auto& index : by_positions_[p])
    enter(*index, id);
}

void AtomIndex::enter(ByPositions& index, AtomId id) {
  project(atoms_[id], index.positions, key_);
  key_.predicate = 0;
  index.lists[key_].push_back(id);
  ++entries_;
}

/// The index over the positions, or where there are too many already, the best one over fewer.
AtomIndex::ByPositions* AtomIndex::indexOver(std::size_t predicate, Positions positions) {
  auto& indices = by_positions_[predicate];
  ByPositions* best = nullptr;
  for (const auto& index : indices) {
    if (index->positions == positions) return index.get();
    if ((index->positions & ~positions) != 0) continue;
    if (best == nullptr ||
        __builtin_popcountll(index->positions) > __builtin_popcountll(best->positions)) {
      best = index.get();
    }
  }
  if (indices.size() == kMaxIndices) return best;
  indices.push_back(std::make_unique<ByPositions>());
  indices.back()->positions = positions;
  for (const AtomId id : all_[predicate]) {
    pollOrThrow(monitor_, "grounding");
    enter(*indices.back(), id);
  }
  return indices.back().get();
}

const std::vector<AtomId>& AtomIndex::matching(const pddl::LiftedAtom& atom,
                                               const std::vector<pddl::ObjectId>& binding) {
  const auto p = static_cast<std::size_t>(atom.predicate);
  const auto value = [&](const pddl::Term& term) {
    return term.is_parameter ? binding[static_cast<std::size_t>(term.index)] : term.index;
  };
  Positions positions = 0;
  for (std::size_t i = 0; i < std::min(atom.terms.size(), kMaxPositions); ++i) {
    if (value(atom.terms[i]) != kUnbound) positions |= Positions{1} << i;
  }
  if (positions == 0 || all_[p].empty()) return all_[p];
  const ByPositions* index = indexOver(p, positions);
  if (index == nullptr) return all_[p];
  key_.predicate = 0;
  key_.objects.clear();
  for (std::size_t i = 0; i < std::min(atom.terms.size(), kMaxPositions); ++i) {
    if (((index->positions >> i) & 1U) != 0) key_.objects.push_back(value(atom.terms[i]));
  }
  const auto found = index->lists.find(key_);
  return found == index->lists.end() ? none_ : found->second;
}

}  // namespace goal_alignment::grounding
