// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/grounding/grounder.h"

#include <algorithm>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/grounding/relaxed_reachability.h"

namespace goal_alignment::grounding {

using pddl::Model;
using pddl::Schema;
using task::FactId;
using task::Operator;

namespace {

constexpr FactId kNoFact = static_cast<FactId>(-1);

}  // namespace

/// Turns what is relaxed reachable into a task: decides which atoms can change, numbers them,
/// writes the operators.
class TaskBuilder {
 public:
  TaskBuilder(const Model& model, const Options& options, const Limits& limits)
      : model_(model), options_(options), limits_(limits), monitor_(limits) {}

  GroundTask build(const std::vector<Literal>& literals) {
    reached_ = relaxedReachability(model_, limits_);
    atom_count_ = reached_.atoms.size();
    initial_.assign(atom_count_, false);
    std::fill_n(initial_.begin(), reached_.initial_count, true);
    findChangingAtoms();
    numberFacts(literals);
    result_.task.operators.reserve(reached_.instantiations.size());
    for (const Instantiation& instantiation : reached_.instantiations) {
      pollLimits();
      addOperator(instantiation);
    }
    nameAtoms();
    return std::move(result_);
  }

 private:
  /// Called once an instantiation, in each pass over them.
  void pollLimits() {
    const LimitReason reason = monitor_.poll();
    if (reason != LimitReason::None) throw LimitReached(reason, "grounding");
  }

  const Schema& schema(const Instantiation& instantiation) const {
    return model_.schemas[static_cast<std::size_t>(instantiation.schema)];
  }

  /// The id of a reached atom, or atom_count_.
  AtomId find(const pddl::LiftedAtom& atom, const Instantiation& instantiation) const {
    const auto found = reached_.ids.find(groundAtom(atom, instantiation.arguments));
    return found == reached_.ids.end() ? static_cast<AtomId>(atom_count_) : found->second;
  }

  /// An atom changes when it is not initially true, or some instantiation deletes it for good.
  void findChangingAtoms() {
    changes_.resize(atom_count_);
    for (AtomId id = 0; id < atom_count_; ++id)
      changes_[id] = !initial_[id];
    std::vector<AtomId> added;
    for (const Instantiation& instantiation : reached_.instantiations) {
      pollLimits();
      const Schema& action = schema(instantiation);
      if (action.del.empty()) continue;
      added.clear();
      for (const pddl::LiftedAtom& atom : action.add)
        added.push_back(find(atom, instantiation));
      for (const pddl::LiftedAtom& atom : action.del) {
        const AtomId id = find(atom, instantiation);
        if (id == atom_count_ || std::find(added.begin(), added.end(), id) != added.end()) continue;
        changes_[id] = true;
      }
    }
  }

  FactId addFact(AtomId id, bool negated) {
    result_.task.facts.push_back({model_.name(reached_.atoms[id]), negated});
    const auto fact = static_cast<FactId>(result_.task.facts.size() - 1);
    if (initial_[id] != negated) result_.task.initial.push_back(fact);
    return fact;
  }

  void numberFacts(const std::vector<Literal>& literals) {
    fact_.assign(atom_count_, kNoFact);
    complement_.assign(atom_count_, kNoFact);
    for (AtomId id = 0; id < atom_count_; ++id) {
      if (changes_[id]) fact_[id] = addFact(id, false);
    }
    const auto complement = [this](AtomId id) {
      if (id != atom_count_ && changes_[id] && complement_[id] == kNoFact) {
        complement_[id] = addFact(id, true);
      }
    };
    for (const Instantiation& instantiation : reached_.instantiations) {
      pollLimits();
      for (const pddl::LiftedLiteral& literal : schema(instantiation).precondition) {
        if (literal.negated) complement(find(literal.atom, instantiation));
      }
    }
    for (const Literal& literal : literals) {
      if (!literal.negated) continue;
      const auto atom = model_.resolve(literal.atom);
      if (!atom) continue;
      const auto found = reached_.ids.find(*atom);
      if (found != reached_.ids.end()) complement(found->second);
    }
    std::sort(result_.task.initial.begin(), result_.task.initial.end());
  }

  task::Cost operatorCost(const Schema& action, const Instantiation& instantiation) const {
    if (options_.unit_costs || !model_.has_costs) return 1;
    if (!action.function_cost) return action.constant_cost;
    const pddl::Atom term = groundAtom(*action.function_cost, instantiation.arguments);
    const auto value = model_.function_values.find(term);
    if (value != model_.function_values.end()) return action.constant_cost + value->second;
    const GroundName name = {model_.functions[static_cast<std::size_t>(term.predicate)].name.name,
                             {}};
    std::string text = "(" + name.name;
    for (const pddl::ObjectId object : term.objects) {
      text += " " + model_.objects[static_cast<std::size_t>(object)].name.spelling;
    }
    throw pddl::SemanticError(model_.problem_source, {},
                              "the cost of action '" + action.name.spelling +
                                  "' needs a value of " + text + "), which :init does not give");
  }

  /// False where the instantiation can never be applied.
  bool fillPrecondition(const Schema& action, const Instantiation& instantiation,
                        Operator& op) const {
    for (const pddl::LiftedLiteral& literal : action.precondition) {
      const AtomId id = find(literal.atom, instantiation);
      if (!literal.negated) {
        if (changes_[id]) op.precondition.push_back(fact_[id]);
      } else if (id != atom_count_) {
        if (!changes_[id]) return false;
        op.precondition.push_back(complement_[id]);
      }
    }
    op.precondition = task::makeFactSet(std::move(op.precondition));
    for (const pddl::LiftedLiteral& literal : action.precondition) {
      if (!literal.negated) continue;
      const AtomId id = find(literal.atom, instantiation);
      if (id == atom_count_) continue;
      if (std::binary_search(op.precondition.begin(), op.precondition.end(), fact_[id]))
        return false;
    }
    return true;
  }

  void addOperator(const Instantiation& instantiation) {
    const Schema& action = schema(instantiation);
    Operator op;
    if (!fillPrecondition(action, instantiation, op)) return;
    std::vector<AtomId> added;
    for (const pddl::LiftedAtom& atom : action.add) {
      const AtomId id = find(atom, instantiation);
      added.push_back(id);
      if (!changes_[id]) continue;
      op.add.push_back(fact_[id]);
      if (complement_[id] != kNoFact) op.del.push_back(complement_[id]);
    }
    for (const pddl::LiftedAtom& atom : action.del) {
      const AtomId id = find(atom, instantiation);
      if (id == atom_count_ || std::find(added.begin(), added.end(), id) != added.end()) continue;
      op.del.push_back(fact_[id]);
      if (complement_[id] != kNoFact) op.add.push_back(complement_[id]);
    }
    op.add = task::makeFactSet(std::move(op.add));
    op.del = task::makeFactSet(std::move(op.del));
    op.cost = operatorCost(action, instantiation);
    if (op.del.empty() && std::includes(op.precondition.begin(), op.precondition.end(),
                                        op.add.begin(), op.add.end())) {
      return;  // changes nothing
    }
    op.name.name = action.name.name;
    for (const pddl::ObjectId object : instantiation.arguments) {
      op.name.arguments.push_back(model_.objects[static_cast<std::size_t>(object)].name.name);
    }
    result_.task.operators.push_back(std::move(op));
  }

  void nameAtoms() {
    using Kind = FactStatus::Kind;
    result_.model_ = &model_;
    result_.atoms_.reserve(atom_count_);
    for (AtomId id = 0; id < atom_count_; ++id) {
      pollLimits();
      GroundTask::AtomStatus status;
      if (changes_[id]) {
        status.positive = {Kind::Variable, fact_[id]};
        if (complement_[id] != kNoFact) status.negative = {Kind::Variable, complement_[id]};
      } else {
        status.positive = {Kind::AlwaysTrue, 0};
        status.negative = {Kind::NeverTrue, 0};
      }
      result_.atoms_.emplace(std::move(reached_.atoms[id]), status);
    }
  }

  const Model& model_;
  Options options_;
  Limits limits_;
  LimitMonitor monitor_;
  RelaxedReachability reached_;
  std::size_t atom_count_ = 0;
  std::vector<bool> initial_;
  std::vector<bool> changes_;
  std::vector<FactId> fact_;        // by AtomId, kNoFact where it never changes
  std::vector<FactId> complement_;  // by AtomId, kNoFact where nobody needs it
  GroundTask result_;
};

FactStatus GroundTask::status(const Literal& literal) const {
  const auto atom = model_->resolve(literal.atom);
  const auto found = atom ? atoms_.find(*atom) : atoms_.end();
  if (found != atoms_.end())
    return literal.negated ? found->second.negative : found->second.positive;
  if (literal.negated) return {FactStatus::Kind::AlwaysTrue, 0};
  return {atom ? FactStatus::Kind::NeverTrue : FactStatus::Kind::Unknown, 0};
}

GroundTask ground(const Model& model, const std::vector<Literal>& literals, const Options& options,
                  const Limits& limits) {
  return TaskBuilder(model, options, limits).build(literals);
}

}  // namespace goal_alignment::grounding
