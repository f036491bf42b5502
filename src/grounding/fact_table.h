// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "goal_alignment/common/limits.h"
#include "goal_alignment/grounding/relaxed_reachability.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::grounding {

constexpr task::FactId kNoFact = static_cast<task::FactId>(-1);
constexpr AtomId kUnreached = pddl::AtomTable::kNone;

/// A literal, as far as it is decided for ever.
struct Decided {
  enum class Kind { True, False, Fact };
  Kind kind = Kind::False;
  task::FactId fact = kNoFact;
};

/// The facts of the task: one for each atom that can change, and complementary facts for those
/// whose negation somebody asks for.
class FactTable {
 public:
  /// `changes`: by AtomId. `facts`: where they are written. All but the limits must outlive the
  /// table. Throws LimitReached.
  FactTable(const pddl::Model& model, const RelaxedReachability& reached,
            const std::vector<bool>& changes, std::vector<Literal>& facts, const Limits& limits);

  AtomId find(const pddl::Atom& atom) const;

  /// What the literal is; a negated one that can change gets its complementary fact.
  Decided decide(const pddl::Atom& atom, bool negated);

  /// kNoFact where the atom never changes, or its complement was never asked for.
  task::FactId fact(AtomId id) const { return fact_[id]; }
  task::FactId complement(AtomId id) const { return complement_[id]; }
  task::FactId addComplement(AtomId id);
  /// The fact that is true where this one is false, or kNoFact.
  task::FactId opposite(task::FactId fact) const;
  /// The same, made where there was none.
  task::FactId addOpposite(task::FactId fact);

  const std::vector<Literal>& facts() const { return facts_; }
  task::FactSet initial() const { return task::makeFactSet(initial_); }

 private:
  task::FactId add(AtomId id, bool negated);

  const pddl::Model& model_;
  const RelaxedReachability& reached_;
  const std::vector<bool>& changes_;
  std::vector<Literal>& facts_;
  std::vector<AtomId> atom_of_;  // by FactId
  std::vector<task::FactId> fact_;
  std::vector<task::FactId> complement_;
  std::vector<task::FactId> initial_;
};

}  // namespace goal_alignment::grounding
