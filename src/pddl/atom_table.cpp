// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/atom_table.h"

namespace goal_alignment::pddl {

AtomId AtomTable::find(AtomView atom) const {
  return ids_.find(AtomHash{}(atom), [&](AtomId id) { return atoms_[id] == atom; });
}

std::pair<AtomId, bool> AtomTable::insert(AtomView atom) {
  const std::size_t hash = AtomHash{}(atom);
  const AtomId known = ids_.find(hash, [&](AtomId id) { return atoms_[id] == atom; });
  if (known != kNone) return {known, false};
  const auto id = static_cast<AtomId>(atoms_.size());
  atoms_.push_back({atom.predicate, objects_.keep(atom.objects)});
  ids_.insert(hash, id);
  return {id, true};
}

}  // namespace goal_alignment::pddl
