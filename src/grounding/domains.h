// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

#include "atom_index.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/grounding/rules.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::grounding {

/// A set of objects.
using Domain = std::vector<bool>;

/// The objects that each variable of a rule may stand for: those of its type that the static atoms
/// of the body support.
class Domains {
 public:
  /// `atoms` and `index` hold the static atoms, all of them.
  Domains(const pddl::Model& model, const pddl::AtomTable& atoms, const AtomIndex& index,
          const Limits& limits)
      : model_(model), atoms_(atoms), index_(index), monitor_(limits) {}

  /// In the order of Rule::variables; empty where one of them can't stand for anything. Domains
  /// that no atom narrows are shared. Throws LimitReached. O(passes · static atoms of the body),
  /// with at most two passes more than twice the body's length.
  std::vector<std::shared_ptr<const Domain>> of(const Rule& rule);

 private:
  const std::shared_ptr<const Domain>& ofType(pddl::TypeId type);
  bool narrow(const pddl::LiftedAtom& lifted);
  bool matches(const pddl::LiftedAtom& lifted, const pddl::AtomView& atom) const;
  void pollLimits();

  const pddl::Model& model_;
  const pddl::AtomTable& atoms_;
  const AtomIndex& index_;
  LimitMonitor monitor_;
  std::unordered_map<pddl::TypeId, std::shared_ptr<const Domain>> of_type_;
  std::unordered_map<int, std::shared_ptr<const Domain>> domains_;  // of the rule, by variable
};

}  // namespace goal_alignment::grounding
