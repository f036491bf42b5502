// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "fact_table.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/task/task.h"

namespace goal_alignment::grounding {

/// A ground condition in disjunctive normal form, no alternative a superset of another: one empty
/// alternative is true, none is false.
using Alternatives = std::vector<task::FactSet>;

/// More alternatives than any action or goal may have.
struct TooManyAlternatives {
  static constexpr std::size_t kMost = 10'000;
};

/// Conditions to facts: quantifiers become conjunctions and disjunctions over objects, what never
/// changes disappears.
class ConditionGrounder {
 public:
  ConditionGrounder(const pddl::Model& model, FactTable& facts, const Limits& limits)
      : model_(model), facts_(facts), limits_(limits), monitor_(limits) {}

  /// Sets what the next conditions mean: their variables, and the objects of those that are free.
  void enter(const std::vector<pddl::Parameter>& variables, std::vector<pddl::ObjectId> binding);

  pddl::Atom atom(const pddl::LiftedAtom& lifted) const { return groundAtom(lifted, binding_); }

  /// Throws TooManyAlternatives, LimitReached.
  Alternatives of(const pddl::Formula& formula);
  Alternatives of(const pddl::LiftedAtom& atom, bool negated);

  /// Both conditions; contradictions are left out.
  Alternatives conjunction(const Alternatives& a, const Alternatives& b);
  /// The same, sorted and without alternatives that another one implies. Throws
  /// TooManyAlternatives where too many are left. O(alternatives²) inclusions at worst.
  Alternatives minimal(Alternatives condition);
  /// The negation of a conjunction.
  Alternatives negation(const task::FactSet& conjunction);
  bool contradicts(const task::FactSet& conjunction) const;

 private:
  Alternatives ofParts(std::vector<Alternatives> parts, bool conjunctive);
  Alternatives ofQuantified(const pddl::Formula& formula);
  void collect(const pddl::Formula& formula, std::size_t from, std::vector<Alternatives>& parts);
  void pollLimits();

  const pddl::Model& model_;
  FactTable& facts_;
  Limits limits_;
  LimitMonitor monitor_;
  const std::vector<pddl::Parameter>* variables_ = nullptr;
  std::vector<pddl::ObjectId> binding_;
};

}  // namespace goal_alignment::grounding
