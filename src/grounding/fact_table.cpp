// SPDX-License-Identifier: BSD-3-Clause
#include "fact_table.h"

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::grounding {

using task::FactId;

FactTable::FactTable(const pddl::Model& model, const RelaxedReachability& reached,
                     const std::vector<bool>& changes, std::vector<Literal>& facts,
                     const Limits& limits)
    : model_(model),
      reached_(reached),
      changes_(changes),
      facts_(facts),
      fact_(reached.atoms.size(), kNoFact),
      complement_(reached.atoms.size(), kNoFact) {
  LimitMonitor monitor(limits);
  facts_.reserve(fact_.size());  // growing, it would move ever more names in one go
  for (AtomId id = 0; id < fact_.size(); ++id) {
    pollOrThrow(monitor, "grounding");
    if (changes[id]) fact_[id] = add(id, false);
  }
}

FactId FactTable::add(AtomId id, bool negated) {
  const auto fact = static_cast<FactId>(facts_.size());
  facts_.push_back({model_.name(reached_.atoms[id]), negated});
  atom_of_.push_back(id);
  const bool initially = id < reached_.initial_count;
  if (initially != negated) initial_.push_back(fact);
  return fact;
}

AtomId FactTable::find(const pddl::Atom& atom) const {
  return reached_.atoms.find(atom);
}

Decided FactTable::decide(const pddl::Atom& atom, bool negated) {
  const AtomId id = find(atom);
  if (id == kUnreached || !changes_[id]) {
    const bool is_true = id != kUnreached;
    return {is_true != negated ? Decided::Kind::True : Decided::Kind::False, kNoFact};
  }
  return {Decided::Kind::Fact, negated ? addComplement(id) : fact_[id]};
}

FactId FactTable::addComplement(AtomId id) {
  if (complement_[id] == kNoFact) complement_[id] = add(id, true);
  return complement_[id];
}

FactId FactTable::opposite(FactId fact) const {
  const AtomId id = atom_of_[fact];
  return facts_[fact].negated ? fact_[id] : complement_[id];
}

FactId FactTable::addOpposite(FactId fact) {
  return facts_[fact].negated ? fact_[atom_of_[fact]] : addComplement(atom_of_[fact]);
}

}  // namespace goal_alignment::grounding
