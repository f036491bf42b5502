// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/validation/execution.h"

#include <utility>

#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::validation {

namespace {

using pddl::ObjectId;
using Kind = Violation::Kind;

ObjectId valueOf(const pddl::Term& term, const std::vector<ObjectId>& arguments) {
  return term.is_parameter ? arguments[term.index] : term.index;
}

/// The ground atom that the schema's atom becomes under these arguments.
pddl::Atom instantiate(const pddl::LiftedAtom& lifted, const std::vector<ObjectId>& arguments) {
  pddl::Atom atom{lifted.predicate, {}};
  atom.objects.reserve(lifted.terms.size());
  for (const pddl::Term& term : lifted.terms)
    atom.objects.push_back(valueOf(term, arguments));
  return atom;
}

/// One step of a plan, against one model.
class Step {
 public:
  Step(const pddl::Model& model, const GroundName& action, std::size_t index)
      : model_(model), action_(action), index_(index) {}

  /// Finds the schema and the arguments' ids; must succeed before anything else is asked.
  std::optional<Violation> bind();
  std::optional<Violation> checkPrecondition(const AtomSet& state) const;
  AtomSet apply(AtomSet state) const;
  std::int64_t cost() const;

 private:
  Violation violation(Kind kind, const std::string& reason) const;
  Violation falsePrecondition(Literal literal) const;
  std::optional<Violation> bindArgument(const std::string& name);
  GroundName functionTerm(const pddl::Atom& term) const;

  const pddl::Model& model_;
  const GroundName& action_;
  std::size_t index_;
  const pddl::Schema* schema_ = nullptr;
  std::vector<ObjectId> arguments_;
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
  return std::nullopt;
}

std::optional<Violation> Step::bindArgument(const std::string& name) {
  const std::optional<ObjectId> object = model_.findObject(name);
  if (!object) {
    std::vector<std::string> known;
    for (const pddl::Object& declared : model_.objects)
      known.push_back(declared.name.spelling);
    return violation(Kind::UnknownObject,
                     "unknown object " + inQuotes(name) + pddl::suggestion(name, known));
  }
  const pddl::Parameter& parameter = schema_->parameters[arguments_.size()];
  const pddl::Object& argument = model_.objects[*object];
  if (!model_.isSubtype(argument.type, parameter.type)) {
    return violation(Kind::WrongType, inQuotes(argument.name.spelling) + " is of type " +
                                          inQuotes(model_.types[argument.type].name.spelling) +
                                          ", but parameter '?" + parameter.name + "' takes " +
                                          inQuotes(model_.types[parameter.type].name.spelling));
  }
  arguments_.push_back(*object);
  return std::nullopt;
}

std::optional<Violation> Step::checkPrecondition(const AtomSet& state) const {
  for (const pddl::Equality& equality : schema_->equalities) {
    const ObjectId left = valueOf(equality.left, arguments_);
    const ObjectId right = valueOf(equality.right, arguments_);
    if ((left == right) != equality.negated) continue;
    const GroundName atom{"=", {model_.objects[left].name.name, model_.objects[right].name.name}};
    return falsePrecondition({atom, equality.negated});
  }
  for (const pddl::LiftedLiteral& literal : schema_->precondition) {
    const pddl::Atom atom = instantiate(literal.atom, arguments_);
    // Closed world: what the state does not hold is false.
    if ((state.count(atom) > 0) != literal.negated) continue;
    return falsePrecondition({model_.name(atom), literal.negated});
  }
  return std::nullopt;
}

AtomSet Step::apply(AtomSet state) const {
  // Deletes first: an atom that is both deleted and added stays true.
  for (const pddl::LiftedAtom& atom : schema_->del)
    state.erase(instantiate(atom, arguments_));
  for (const pddl::LiftedAtom& atom : schema_->add)
    state.insert(instantiate(atom, arguments_));
  return state;
}

std::int64_t Step::cost() const {
  // As the IPC counts: without a metric it is the plan's length.
  if (!model_.has_costs) return 1;
  if (!schema_->function_cost) return schema_->constant_cost;
  const pddl::Atom term = instantiate(*schema_->function_cost, arguments_);
  const auto value = model_.function_values.find(term);
  if (value != model_.function_values.end()) return value->second;
  // Not a violation of the plan: no plan that uses this action has a cost.
  throw pddl::SemanticError(model_.problem_source, {},
                            "the cost of " + model_.spelling(action_) + " is not given: " +
                                functionTerm(term).text() + " has no value in :init");
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

Execution execute(const pddl::Model& model, const std::vector<GroundName>& plan) {
  Execution execution;
  execution.states.emplace_back(model.init.begin(), model.init.end());
  execution.costs.push_back(0);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    Step step(model, plan[i], i);
    execution.violation = step.bind();
    if (!execution.violation) execution.violation = step.checkPrecondition(execution.finalState());
    if (execution.violation) break;
    execution.costs.push_back(execution.cost() + step.cost());
    execution.states.push_back(step.apply(execution.finalState()));
  }
  return execution;
}

std::vector<Literal> unsatisfied(const pddl::Model& model, const AtomSet& state,
                                 const std::vector<Literal>& goal) {
  std::vector<Literal> missing;
  for (const Literal& literal : goal) {
    if (!holds(model, state, literal)) missing.push_back(literal);
  }
  return missing;
}

std::optional<std::string> fault(const pddl::Model& model, const std::vector<GroundName>& plan,
                                 const std::vector<Literal>& goal) {
  const Execution execution = execute(model, plan);
  if (execution.violation) return execution.violation->message;
  const std::vector<Literal> missing = unsatisfied(model, execution.finalState(), goal);
  if (missing.empty()) return std::nullopt;
  std::string message = "the plan runs, but ends without the goal";
  for (const Literal& literal : missing) {
    const std::string atom = model.spelling(literal.atom);
    message += (literal.negated ? " (not " + atom + ")" : " " + atom);
  }
  return message;
}

}  // namespace goal_alignment::validation
