// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::grounding {

/// Index of an atom in RelaxedReachability::atoms.
using AtomId = std::uint32_t;

/// An action schema with all its parameters bound.
struct Instantiation {
  pddl::SchemaId schema = 0;
  std::vector<pddl::ObjectId> arguments;
};

/// What can be reached when nothing is ever deleted and every negative precondition that can ever
/// hold holds: a superset of what is reachable.
struct RelaxedReachability {
  std::vector<pddl::Atom> atoms;  ///< the initial ones first, static ones before the others
  std::size_t initial_count = 0;
  std::unordered_map<pddl::Atom, AtomId, pddl::AtomHash> ids;
  std::vector<Instantiation> instantiations;
};

/// Semi-naive join of the schemas' positive preconditions: every instantiation is found once, when
/// the last of its atoms appears; the most selective precondition is matched next, through an index
/// on (predicate, argument position, object). Never enumerates parameter tuples, except for
/// parameters that no positive precondition mentions.
///
/// After Helmert, "Concise finite-domain representations for PDDL planning tasks", AIJ 173 (2009),
/// section 6, with a nested-loop join in place of the Datalog decomposition.
///
/// Throws LimitReached.
RelaxedReachability relaxedReachability(const pddl::Model& model, const Limits& limits);

/// The atom under a binding of the schema's parameters.
pddl::Atom groundAtom(const pddl::LiftedAtom& atom, const std::vector<pddl::ObjectId>& arguments);

}  // namespace goal_alignment::grounding
