// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/validation/execution.h"

#include <utility>

#include "evaluation.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::validation {

namespace {

using pddl::ObjectId;
using Kind = Violation::Kind;

/// One step of a plan, against one model.
class Step {
 public:
  Step(const pddl::Model& model, const GroundName& action, std::size_t index, LimitMonitor& monitor)
      : model_(model), action_(action), index_(index), monitor_(monitor) {}

  /// Finds the schema and the arguments' ids; must succeed before anything else is asked.
  std::optional<Violation> bind();
  std::optional<Violation> checkPrecondition(const AtomSet& state);
  /// What the step adds and deletes in this state; an atom may be among both.
  AtomSet added(const AtomSet& state) { return touched(state, true); }
  AtomSet deleted(const AtomSet& state) { return touched(state, false); }
  std::int64_t cost() const;

 private:
  Violation violation(Kind kind, const std::string& reason) const;
  Violation falsePrecondition(Literal literal) const;
  AtomSet touched(const AtomSet& state, bool add);
  std::optional<Violation> bindArgument(const std::string& name);
  std::int64_t valueOf(const pddl::Atom& function) const;
  GroundName functionTerm(const pddl::Atom& term) const;

  const pddl::Model& model_;
  const GroundName& action_;
  std::size_t index_;
  LimitMonitor& monitor_;
  const pddl::Schema* schema_ = nullptr;
  std::vector<pddl::Parameter> variables_;  // the parameters, then what formulas quantify
  Binding binding_;
};

Violation Step::violation(Kind kind, const std::string& reason) const {
  Violation violation;
  violation.kind = kind;
  violation.step = index_;
  violation.message =
      "step " + std::to_string(index_ + 1) + " " + model_.spelling(action_) + ": " + reason;
  return violation;
}

Violation Step::falsePrecondition(Literal literal) const {
  const std::string atom = model_.spelling(literal.atom);
  Violation found = violation(
      Kind::Precondition,
      "the precondition " + (literal.negated ? "(not " + atom + ")" : atom) + " is false");
  found.missing = {literal};
  found.literal = std::move(literal);
  return found;
}

std::optional<Violation> Step::bind() {
  // From the name inwards, so that the first thing wrong is the one that is told.
  const std::optional<pddl::SchemaId> id = model_.findSchema(action_.name);
  if (!id) {
    // Only a broken plan pays for the list of names.
    std::vector<std::string> known;
    for (const pddl::Schema& schema : model_.schemas)
      known.push_back(schema.name.spelling);
    return violation(Kind::UnknownAction, "unknown action " + inQuotes(action_.name) +
                                              pddl::suggestion(action_.name, known));
  }
  schema_ = &model_.schemas[*id];
  const std::size_t takes = schema_->parameters.size();
  if (takes != action_.arguments.size()) {
    return violation(Kind::WrongArity, inQuotes(schema_->name.spelling) + " takes " +
                                           std::to_string(takes) +
                                           (takes == 1 ? " argument" : " arguments") + ", found " +
                                           std::to_string(action_.arguments.size()));
  }
  for (const std::string& name : action_.arguments) {
    if (std::optional<Violation> found = bindArgument(name)) return found;
  }
  variables_ = schema_->parameters;
  variables_.insert(variables_.end(), schema_->quantified.begin(), schema_->quantified.end());
  binding_.resize(variables_.size(), kUnbound);
  return std::nullopt;
}

std::optional<Violation> Step::bindArgument(const std::string& name) {
  const std::optional<ObjectId> object = model_.findObject(name);
  if (!object) {
    std::vector<std::string> known;
    for (const pddl::Object& declared : model_.objects)
      known.push_back(declared.name.spelling);
    Violation found = violation(Kind::UnknownObject,
                                "unknown object " + inQuotes(name) + pddl::suggestion(name, known));
    found.object = name;
    return found;
  }
  const pddl::Parameter& parameter = schema_->parameters[binding_.size()];
  const pddl::Object& argument = model_.objects[*object];
  if (!model_.isSubtype(argument.type, parameter.type)) {
    Violation found =
        violation(Kind::WrongType, inQuotes(argument.name.spelling) + " is of type " +
                                       inQuotes(model_.types[argument.type].name.spelling) +
                                       ", but parameter '?" + parameter.name + "' takes " +
                                       inQuotes(model_.types[parameter.type].name.spelling));
    found.object = name;
    return found;
  }
  binding_.push_back(*object);
  return std::nullopt;
}

std::optional<Violation> Step::checkPrecondition(const AtomSet& state) {
  Evaluation evaluation(model_, state, variables_, binding_, monitor_);
  for (const pddl::Equality& equality : schema_->equalities) {
    if (evaluation.holds(equality)) continue;
    const pddl::Atom pair = instantiate({0, {equality.left, equality.right}}, binding_);
    const auto name = [&](std::size_t i) { return model_.objects[pair.objects[i]].name.name; };
    return falsePrecondition({{"=", {name(0), name(1)}}, equality.negated});
  }
  for (const pddl::LiftedLiteral& literal : schema_->precondition) {
    if (evaluation.holds(literal)) continue;
    return falsePrecondition({model_.name(instantiate(literal.atom, binding_)), literal.negated});
  }
  for (const pddl::Formula& part : schema_->condition.parts) {
    if (evaluation.holds(part)) continue;
    Violation found =
        violation(Kind::Precondition,
                  "the precondition " + model_.text(part, variables_, binding_) + " is false");
    found.missing = evaluation.missing(part);
    return found;
  }
  return std::nullopt;
}

AtomSet Step::touched(const AtomSet& state, bool add) {
  AtomSet atoms;
  const auto touch = [&](const auto& effect) {
    for (const pddl::LiftedAtom& atom : add ? effect.add : effect.del)
      atoms.insert(instantiate(atom, binding_));
    return false;  // on to the next binding
  };
  touch(*schema_);
  Evaluation evaluation(model_, state, variables_, binding_, monitor_);
  for (const pddl::ConditionalEffect& effect : schema_->conditional) {
    evaluation.anyBinding(effect.variables,
                          [&] { return evaluation.holds(effect.condition) && touch(effect); });
  }
  return atoms;
}

std::int64_t Step::cost() const {
  // As the IPC counts: without a metric it is the plan's length.
  if (!model_.has_costs) return 1;
  std::int64_t cost = schema_->constant_cost;
  for (const pddl::LiftedAtom& function : schema_->function_costs)
    cost += valueOf(instantiate(function, binding_));
  return cost;
}

std::int64_t Step::valueOf(const pddl::Atom& function) const {
  const auto value = model_.function_values.find(function);
  if (value != model_.function_values.end()) return value->second;
  // Not a violation of the plan: no plan that uses this action has a cost.
  throw pddl::SemanticError(model_.problem_source, {},
                            "the cost of " + model_.spelling(action_) + " is not given: " +
                                functionTerm(function).text() + " has no value in :init");
}

GroundName Step::functionTerm(const pddl::Atom& term) const {
  GroundName name{model_.functions[term.predicate].name.spelling, {}};
  for (const ObjectId object : term.objects) {
    name.arguments.push_back(model_.objects[object].name.spelling);
  }
  return name;
}

bool holds(const pddl::Model& model, const AtomSet& state, const Literal& literal) {
  // An unknown atom, say of the other model, is never true.
  const std::optional<pddl::Atom> atom = model.resolve(literal.atom);
  return (atom && state.count(*atom) > 0) != literal.negated;
}

}  // namespace

void Execution::forEachState(const std::function<void(std::size_t, const AtomSet&)>& visit) const {
  // Back to the start first: only the end is there as a whole.
  AtomSet state = final_;
  for (auto change = changes_.rbegin(); change != changes_.rend(); ++change) {
    for (const pddl::Atom& atom : change->added)
      state.erase(atom);
    state.insert(change->removed.begin(), change->removed.end());
  }
  visit(0, state);
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    for (const pddl::Atom& atom : changes_[i].removed)
      state.erase(atom);
    state.insert(changes_[i].added.begin(), changes_[i].added.end());
    visit(i + 1, state);
  }
}

Execution execute(const pddl::Model& model, const std::vector<GroundName>& plan,
                  const Limits& limits) {
  LimitMonitor monitor(limits);
  Execution execution;
  AtomSet& state = execution.final_;
  for (const pddl::Atom& atom : model.init) {
    pollOrThrow(monitor, "executing a plan");
    state.insert(atom);
  }
  execution.costs.push_back(0);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    Step step(model, plan[i], i, monitor);
    execution.violation = step.bind();
    if (!execution.violation) execution.violation = step.checkPrecondition(state);
    if (execution.violation) break;
    execution.costs.push_back(execution.cost() + step.cost());
    // Both are decided before anything changes. An atom that is deleted and added stays true.
    const AtomSet added = step.added(state);
    const AtomSet deleted = step.deleted(state);
    Execution::Change change;
    for (const pddl::Atom& atom : deleted) {
      if (added.count(atom) == 0 && state.erase(atom) > 0) change.removed.push_back(atom);
    }
    for (const pddl::Atom& atom : added) {
      if (state.insert(atom).second) change.added.push_back(atom);
    }
    execution.changes_.push_back(std::move(change));
  }
  return execution;
}

std::vector<Literal> unsatisfied(const pddl::Model& model, const AtomSet& state,
                                 const std::vector<Literal>& goal, const Limits& limits) {
  std::vector<Literal> missing;
  LimitMonitor monitor(limits);
  for (const Literal& literal : goal) {
    pollOrThrow(monitor, "checking a goal");
    if (!holds(model, state, literal)) missing.push_back(literal);
  }
  return missing;
}

bool satisfiesCondition(const pddl::Model& model, const AtomSet& state, const Limits& limits) {
  LimitMonitor monitor(limits);
  Binding binding(model.goal_variables.size(), kUnbound);
  return Evaluation(model, state, model.goal_variables, binding, monitor)
      .holds(model.goal_condition);
}

std::optional<std::string> fault(const pddl::Model& model, const std::vector<GroundName>& plan,
                                 const std::vector<Literal>& goal, const Limits& limits) {
  const Execution execution = execute(model, plan, limits);
  if (execution.violation) return execution.violation->message;
  std::string missing;
  for (const Literal& literal : unsatisfied(model, execution.finalState(), goal, limits)) {
    const std::string atom = model.spelling(literal.atom);
    missing += (literal.negated ? " (not " + atom + ")" : " " + atom);
  }
  if (!satisfiesCondition(model, execution.finalState(), limits)) {
    missing += " " + model.goalConditionText();
  }
  if (missing.empty()) return std::nullopt;
  return "the plan runs, but ends without the goal" + missing;
}

}  // namespace goal_alignment::validation
