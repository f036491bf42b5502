// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "goal_alignment/common/blocks.h"
#include "goal_alignment/common/id_table.h"
#include "goal_alignment/common/span.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::pddl {

/// Index of an atom in an AtomTable.
using AtomId = IdTable::Id;

/// Atoms without duplicates, numbered in the order of insertion, and findable. Their objects stand
/// in few blocks, so that millions of them are soon freed.
class AtomTable {
 public:
  static constexpr AtomId kNone = IdTable::kNone;

  /// The atom's number, and whether it is new. Expected O(objects), like find().
  std::pair<AtomId, bool> insert(AtomView atom);
  /// kNone where it is not there.
  AtomId find(AtomView atom) const;

  /// Its objects stay where they are.
  AtomView operator[](AtomId id) const { return atoms_[id]; }
  std::size_t size() const { return atoms_.size(); }

  auto begin() const { return atoms_.begin(); }
  auto end() const { return atoms_.end(); }

 private:
  BlockVector<AtomView> atoms_;
  ArrayStore<ObjectId> objects_;
  IdTable ids_;
};

}  // namespace goal_alignment::pddl
