// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "goal_alignment/common/blocks.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/common/span.h"
#include "goal_alignment/grounding/rules.h"
#include "goal_alignment/pddl/atom_table.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::grounding {

/// Index of an atom in RelaxedReachability::atoms.
using pddl::AtomId;

/// A rule with its variables bound.
struct Instantiation {
  std::size_t rule = 0;            ///< index in RelaxedReachability::rules
  Span<pddl::ObjectId> arguments;  ///< of Rule::variables: the action's parameters come first
};

/// What can be reached when nothing is ever deleted, every negative condition that can ever hold
/// holds, and of universal conditions only what never changes counts: a superset of what is
/// reachable.
struct RelaxedReachability {
  pddl::AtomTable atoms;  ///< the initial ones first, static ones before the others
  std::size_t initial_count = 0;
  std::vector<Rule> rules;
  BlockVector<Instantiation> instantiations;  ///< without duplicates of one rule; where bindings
                                              ///< differ in no atom that can change, one of them
  ArrayStore<pddl::ObjectId> arguments;       ///< of the instantiations
  std::uint64_t match_attempts = 0;           ///< atoms and objects tried: the work of the join
};

/// Semi-naive join of the rules' bodies: every instantiation is found once, when the last of its
/// atoms appears; the atom with the fewest matches is matched next, and where one has none the
/// binding is given up at once. Before, what never changes narrows the objects of every variable
/// until all of them are supported (arc consistency), so that along chains and trees of static
/// atoms nothing is tried in vain. Variables that no atom mentions come last, and range over their
/// type.
///
/// After Helmert, "Concise finite-domain representations for PDDL planning tasks", AIJ 173 (2009),
/// section 6, with a nested-loop join in place of the Datalog decomposition; arc consistency after
/// Freuder, "A sufficient condition for backtrack-free search", JACM 29 (1982).
///
/// Throws LimitReached.
RelaxedReachability relaxedReachability(const pddl::Model& model, const Limits& limits);

/// The atom under a binding of the variables that it mentions.
pddl::Atom groundAtom(const pddl::LiftedAtom& atom, const std::vector<pddl::ObjectId>& binding);

/// Writes the arguments to where the rule's variables stand in `binding`, which has room for them.
void bind(const Rule& rule, Span<pddl::ObjectId> arguments, std::vector<pddl::ObjectId>& binding);

}  // namespace goal_alignment::grounding
