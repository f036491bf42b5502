// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fact_table.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/common/span.h"
#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/grounding/relaxed_reachability.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/task/task.h"
#include "ground_condition.h"

namespace goal_alignment::grounding {

/// Writes the operators, in two passes: what effects do to a complementary fact can be said only
/// once all conditions have named the ones they need.
class OperatorBuilder {
 public:
  /// `operators`: where they are written. All but options and limits must outlive this.
  OperatorBuilder(const pddl::Model& model, const RelaxedReachability& reached,
                  const std::vector<bool>& changes, FactTable& facts,
                  std::vector<task::Operator>& operators, const Options& options,
                  const Limits& limits);

  /// Once. Throws LimitReached; pddl::SemanticError, pddl::UnsupportedError as ground() does.
  void build();

 private:
  /// All instantiations of one action with its arguments: one for each alternative of its
  /// precondition, and those of its conditional effects.
  using Group = Span<std::uint32_t>;

  /// Which conditional effects of an operator, or kAlways, add or delete an atom.
  struct Touch {
    std::vector<std::size_t> added_by;
    std::vector<std::size_t> deleted_by;
  };
  static constexpr std::size_t kAlways = static_cast<std::size_t>(-1);

  const Rule& ruleOf(std::size_t instantiation) const;
  const pddl::Schema& schemaOf(std::size_t instantiation) const;
  bool isAction(std::size_t instantiation) const;
  void collectGroups();
  std::vector<std::uint32_t> numberGroups();
  Group group(std::size_t number) const;
  void addGroup(Group group);
  std::vector<task::ConditionalEffect> groundEffects(Group group);
  void enter(std::size_t instantiation);
  Alternatives conditionOf(std::size_t instantiation);
  std::vector<AtomId> reachedAtoms(const std::vector<pddl::LiftedAtom>& atoms) const;
  void addOperator(std::size_t instantiation, task::FactSet precondition,
                   const std::vector<task::ConditionalEffect>& effects);
  bool assume(const task::FactSet& precondition, task::FactSet& condition) const;
  void letAddsWin(task::Operator& op) const;
  void completeComplements();
  bool completeComplements(const task::Operator& op);
  void writeEffects(task::Operator& op);
  void writeComplement(task::FactId complement, const Touch& by, const task::Operator& drafted,
                       task::Operator& op);
  task::Cost cost(std::size_t instantiation) const;
  task::Cost valueOf(const pddl::Schema& action, const pddl::Atom& function) const;
  void account(const task::Operator& op);
  void pollLimits();

  const pddl::Model& model_;
  const RelaxedReachability& reached_;
  const std::vector<bool>& changes_;
  FactTable& facts_;
  Options options_;
  Limits limits_;
  LimitMonitor monitor_;
  ConditionGrounder conditions_;
  std::vector<std::vector<pddl::Parameter>> variables_;  // by schema
  std::vector<std::uint32_t> members_;                   // instantiations, group by group …
  std::vector<std::size_t> group_ends_;  // … each of which ends before this one of them
  std::vector<task::Operator>& operators_;
  std::size_t bytes_ = 0;
};

}  // namespace goal_alignment::grounding
