// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/grounding/grounder.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fact_table.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/grounding/relaxed_reachability.h"
#include "ground_condition.h"
#include "operator_builder.h"

namespace goal_alignment::grounding {

using pddl::Model;
using pddl::Schema;
using task::FactId;

/// Turns what is relaxed reachable into a task: decides which atoms can change, has their facts
/// numbered and the operators written.
class TaskBuilder {
 public:
  TaskBuilder(const Model& model, const Options& options, const Limits& limits)
      : model_(model), options_(options), limits_(limits), monitor_(limits) {}

  GroundTask build(const std::vector<Literal>& literals) {
    reached_ = relaxedReachability(model_, limits_);
    findChangingAtoms();
    FactTable facts(model_, reached_, changes_, result_.task.facts, limits_);
    OperatorBuilder operators(model_, reached_, changes_, facts, result_.task.operators, options_,
                              limits_);
    for (const Literal& literal : literals) {
      if (!literal.negated) continue;
      if (const auto atom = model_.resolve(literal.atom)) facts.decide(*atom, true);
    }
    groundGoalCondition(facts);
    operators.build();
    nameAtoms(facts);
    result_.task.initial = facts.initial();
    return std::move(result_);
  }

 private:
  /// Called once an instantiation, in each pass over them.
  void pollLimits() { pollOrThrow(monitor_, "grounding"); }

  /// An atom changes when it is not initially true, or some instantiation deletes it and does not
  /// add it under any circumstances.
  void findChangingAtoms() {
    changes_.assign(reached_.atoms.size(), true);
    std::fill_n(changes_.begin(), reached_.initial_count, false);
    std::vector<pddl::ObjectId> binding;
    std::vector<AtomId> added;
    for (const Instantiation& instantiation : reached_.instantiations) {
      pollLimits();
      const Rule& rule = reached_.rules[instantiation.rule];
      const Schema& schema = model_.schemas[static_cast<std::size_t>(rule.schema)];
      const auto& deleted =
          rule.effect == Rule::kAction ? schema.del : schema.conditional[rule.effect].del;
      if (deleted.empty()) continue;
      binding.resize(schema.parameters.size() + schema.quantified.size());
      bind(rule, instantiation.arguments, binding);
      added.clear();
      for (const pddl::LiftedAtom& atom : schema.add)
        added.push_back(reached_.atoms.find(groundAtom(atom, binding)));
      for (const pddl::LiftedAtom& lifted : deleted) {
        const AtomId atom = reached_.atoms.find(groundAtom(lifted, binding));
        if (atom == pddl::AtomTable::kNone) continue;
        if (std::find(added.begin(), added.end(), atom) == added.end()) changes_[atom] = true;
      }
    }
  }

  void groundGoalCondition(FactTable& facts) {
    ConditionGrounder conditions(model_, facts, limits_);
    conditions.enter(model_.goal_variables,
                     std::vector<pddl::ObjectId>(model_.goal_variables.size()));
    try {
      result_.condition_ = conditions.of(model_.goal_condition);
    } catch (const TooManyAlternatives&) {
      throw pddl::UnsupportedError(model_.problem_source, {},
                                   "not supported yet: more than " +
                                       std::to_string(TooManyAlternatives::kMost) +
                                       " alternatives in the goal");
    }
  }

  void nameAtoms(const FactTable& facts) {
    using Kind = FactStatus::Kind;
    result_.model_ = &model_;
    result_.statuses_.reserve(reached_.atoms.size());
    for (AtomId id = 0; id < reached_.atoms.size(); ++id) {
      pollLimits();
      GroundTask::AtomStatus status;
      if (changes_[id]) {
        status.positive = {Kind::Variable, facts.fact(id)};
        const FactId complement = facts.complement(id);
        if (complement != kNoFact) status.negative = FactStatus{Kind::Variable, complement};
      } else {
        status.positive = {Kind::AlwaysTrue, 0};
        status.negative = FactStatus{Kind::NeverTrue, 0};
      }
      result_.statuses_.push_back(status);
    }
    result_.atoms_ = std::move(reached_.atoms);
  }

  const Model& model_;
  Options options_;
  Limits limits_;
  LimitMonitor monitor_;
  RelaxedReachability reached_;
  std::vector<bool> changes_;  // by AtomId
  GroundTask result_;
};

FactStatus GroundTask::status(const Literal& literal) const {
  const auto atom = model_->resolve(literal.atom);
  const AtomId found = atom ? atoms_.find(*atom) : pddl::AtomTable::kNone;
  if (found != pddl::AtomTable::kNone && !literal.negated) return statuses_[found].positive;
  if (found != pddl::AtomTable::kNone) {
    const auto& status = statuses_[found].negative;
    if (!status) throw std::logic_error("grounded without asking for " + literal.text());
    return *status;
  }
  if (literal.negated) return {FactStatus::Kind::AlwaysTrue, 0};
  return {atom ? FactStatus::Kind::NeverTrue : FactStatus::Kind::Unknown, 0};
}

task::Goal GroundTask::goal(const std::vector<Literal>& literals) const {
  std::vector<FactId> facts;
  for (const Literal& literal : literals) {
    const FactStatus is = status(literal);
    if (is.kind == FactStatus::Kind::AlwaysTrue) continue;
    if (is.kind != FactStatus::Kind::Variable) return {};
    facts.push_back(is.fact);
  }
  task::Goal goal;
  for (task::FactSet alternative : condition_) {
    alternative.insert(alternative.end(), facts.begin(), facts.end());
    goal.alternatives.push_back(task::makeFactSet(std::move(alternative)));
  }
  return goal;
}

GroundTask ground(const Model& model, const std::vector<Literal>& literals, const Options& options,
                  const Limits& limits) {
  return TaskBuilder(model, options, limits).build(literals);
}

}  // namespace goal_alignment::grounding
