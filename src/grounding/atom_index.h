// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/grounding/relaxed_reachability.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::grounding {

constexpr pddl::ObjectId kUnbound = -1;

/// Atoms that have appeared, findable by any of their arguments together. An index over a set of
/// argument positions is built when it is first asked for.
class AtomIndex {
 public:
  /// `atoms` may grow; what is not inserted is not seen. Must outlive the index.
  AtomIndex(const pddl::AtomTable& atoms, std::size_t predicates, const Limits& limits)
      : atoms_(atoms), monitor_(limits), all_(predicates), by_positions_(predicates) {}

  void insert(AtomId id);

  const std::vector<AtomId>& all(pddl::PredicateId predicate) const {
    return all_[static_cast<std::size_t>(predicate)];
  }

  /// The atoms that match the lifted atom under the binding: exactly those, but for terms that
  /// occur twice unbound, more than 64 arguments, or more indices than a predicate may have.
  /// Valid until the next insert(). O(arguments); O(atoms of the predicate) where it builds an
  /// index. Throws LimitReached.
  const std::vector<AtomId>& matching(const pddl::LiftedAtom& atom,
                                      const std::vector<pddl::ObjectId>& binding);

  /// What the indices take, about.
  std::size_t bytes() const { return entries_ * kBytesPerEntry; }

 private:
  using Positions = std::uint64_t;  // a set of argument positions
  static constexpr std::size_t kBytesPerEntry = 48;

  struct ByPositions {
    Positions positions = 0;
    std::unordered_map<pddl::Atom, std::vector<AtomId>, pddl::AtomHash> lists;
  };

  ByPositions* indexOver(std::size_t predicate, Positions positions);
  void enter(ByPositions& index, AtomId id);

  const pddl::AtomTable& atoms_;
  LimitMonitor monitor_;
  std::vector<std::vector<AtomId>> all_;
  std::vector<std::vector<std::unique_ptr<ByPositions>>> by_positions_;
  std::vector<AtomId> none_;
  pddl::Atom key_;  // of the last lookup
  std::size_t entries_ = 0;
};

}  // namespace goal_alignment::grounding
