// SPDX-License-Identifier: BSD-3-Clause
#include "operator_builder.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "atom_index.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/quote.h"

namespace goal_alignment::grounding {

using pddl::Schema;
using task::ConditionalEffect;
using task::FactSet;
using task::Operator;

namespace {

void subtract(FactSet& from, const FactSet& what) {
  from.erase(std::remove_if(from.begin(), from.end(),
                            [&](std::uint32_t element) { return task::has(what, element); }),
             from.end());
}

void append(Alternatives& to, Alternatives from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

void insert(FactSet& into, const FactSet& what) {
  into.insert(into.end(), what.begin(), what.end());
  into = task::makeFactSet(std::move(into));
}

}  // namespace

OperatorBuilder::OperatorBuilder(const pddl::Model& model, const RelaxedReachability& reached,
                                 const std::vector<bool>& changes, FactTable& facts,
                                 std::vector<task::Operator>& operators, const Options& options,
                                 const Limits& limits)
    : model_(model),
      reached_(reached),
      changes_(changes),
      facts_(facts),
      options_(options),
      limits_(limits),
      monitor_(limits),
      conditions_(model, facts, limits),
      operators_(operators) {
  for (const Schema& schema : model.schemas) {
    variables_.push_back(schema.parameters);
    variables_.back().insert(variables_.back().end(), schema.quantified.begin(),
                             schema.quantified.end());
  }
}

void OperatorBuilder::build() {
  collectGroups();
  // Growing bit by bit, it would move ever more operators in one go.
  operators_.reserve(group_ends_.size());
  for (std::size_t number = 0; number < group_ends_.size(); ++number)
    addGroup(group(number));
  completeComplements();
  std::size_t kept = 0;
  for (Operator& op : operators_) {
    pollLimits();
    writeEffects(op);
    const bool changes_nothing =
        op.del.empty() && op.conditional.empty() &&
        std::includes(op.precondition.begin(), op.precondition.end(), op.add.begin(), op.add.end());
    if (changes_nothing) continue;
    if (&operators_[kept] != &op) operators_[kept] = std::move(op);
    ++kept;
  }
  operators_.resize(kept);
}

const Rule& OperatorBuilder::ruleOf(std::size_t instantiation) const {
  return reached_.rules[reached_.instantiations[instantiation].rule];
}

const Schema& OperatorBuilder::schemaOf(std::size_t instantiation) const {
  return model_.schemas[static_cast<std::size_t>(ruleOf(instantiation).schema)];
}

bool OperatorBuilder::isAction(std::size_t instantiation) const {
  return ruleOf(instantiation).effect == Rule::kAction;
}

/// The group of each instantiation, in the order of their first one.
std::vector<std::uint32_t> OperatorBuilder::numberGroups() {
  std::vector<std::size_t> rules(model_.schemas.size(), 0);
  for (const Rule& rule : reached_.rules)
    ++rules[static_cast<std::size_t>(rule.schema)];
  std::vector<std::uint32_t> group_of;
  group_of.reserve(reached_.instantiations.size());
  pddl::AtomTable shared;                      // actions with their arguments
  std::vector<std::uint32_t> group_of_shared;  // by AtomId
  std::uint32_t groups = 0;
  for (std::size_t i = 0; i < reached_.instantiations.size(); ++i) {
    pollLimits();
    const pddl::SchemaId schema = ruleOf(i).schema;
    const auto& arguments = reached_.instantiations[i].arguments;
    // One rule whose variables are the parameters makes every instantiation a group of its own.
    const std::size_t parameters = schemaOf(i).parameters.size();
    const bool alone =
        rules[static_cast<std::size_t>(schema)] == 1 && arguments.size() == parameters;
    bool is_new = true;
    AtomId id = 0;
    if (!alone) std::tie(id, is_new) = shared.insert({schema, {arguments.begin(), parameters}});
    if (is_new && !alone) group_of_shared.push_back(groups);
    group_of.push_back(is_new ? groups++ : group_of_shared[id]);
    if (is_new) group_ends_.push_back(0);
  }
  return group_of;
}

/// Counting sort.
void OperatorBuilder::collectGroups() {
  const std::vector<std::uint32_t> group_of = numberGroups();
  for (const std::uint32_t group : group_of)
    ++group_ends_[group];
  std::size_t end = 0;
  for (std::size_t& size : group_ends_)
    size = std::exchange(end, end + size);  // now where it begins
  members_.resize(group_of.size());
  for (std::size_t i = 0; i < group_of.size(); ++i) {
    pollLimits();
    members_[group_ends_[group_of[i]]++] = static_cast<std::uint32_t>(i);
  }
}

OperatorBuilder::Group OperatorBuilder::group(std::size_t number) const {
  const std::size_t begin = number == 0 ? 0 : group_ends_[number - 1];
  return {members_.data() + begin, group_ends_[number] - begin};
}

void OperatorBuilder::enter(std::size_t instantiation) {
  const Rule& rule = ruleOf(instantiation);
  const auto& variables = variables_[static_cast<std::size_t>(rule.schema)];
  std::vector<pddl::ObjectId> binding(variables.size(), kUnbound);
  bind(rule, reached_.instantiations[instantiation].arguments, binding);
  conditions_.enter(variables, std::move(binding));
}

/// Of the instantiation that was entered last.
Alternatives OperatorBuilder::conditionOf(std::size_t instantiation) {
  const Rule& rule = ruleOf(instantiation);
  FactSet facts;
  bool possible = true;
  const auto conjoin = [&](const std::vector<pddl::LiftedAtom>& atoms, bool negated) {
    for (const pddl::LiftedAtom& atom : atoms) {
      // The join has seen to what is static, and to the action of a conditional effect.
      const auto p = static_cast<std::size_t>(atom.predicate);
      if (p >= model_.predicates.size() || !model_.predicates[p].fluent) continue;
      const Decided decided = facts_.decide(conditions_.atom(atom), negated);
      if (decided.kind == Decided::Kind::False) possible = false;
      if (decided.kind == Decided::Kind::Fact) facts.push_back(decided.fact);
    }
  };
  conjoin(rule.body, false);
  conjoin(rule.absent, true);
  if (!possible) return {};
  facts = task::makeFactSet(std::move(facts));
  if (conditions_.contradicts(facts)) return {};
  Alternatives condition = {std::move(facts)};
  for (const pddl::Formula* formula : rule.residual)
    condition = conditions_.conjunction(condition, conditions_.of(*formula));
  return condition;
}

std::vector<AtomId> OperatorBuilder::reachedAtoms(
    const std::vector<pddl::LiftedAtom>& atoms) const {
  std::vector<AtomId> ids;
  for (const pddl::LiftedAtom& atom : atoms) {
    const AtomId id = facts_.find(conditions_.atom(atom));
    if (id != kUnreached && changes_[id]) ids.push_back(id);
  }
  return task::makeFactSet(std::move(ids));
}

/// Until writeEffects(), `add` and `del` of operators and effects hold AtomIds.
std::vector<ConditionalEffect> OperatorBuilder::groundEffects(Group group) {
  std::map<std::pair<FactSet, FactSet>, Alternatives> conditions;
  for (const std::size_t instantiation : group) {
    pollLimits();
    if (isAction(instantiation)) continue;
    enter(instantiation);
    const pddl::ConditionalEffect& effect =
        schemaOf(instantiation).conditional[ruleOf(instantiation).effect];
    std::pair<FactSet, FactSet> changed{reachedAtoms(effect.add), reachedAtoms(effect.del)};
    subtract(changed.second, changed.first);
    if (changed.first.empty() && changed.second.empty()) continue;
    append(conditions[changed], conditionOf(instantiation));
  }
  std::vector<ConditionalEffect> effects;
  for (auto& [changed, condition] : conditions) {
    for (const FactSet& alternative : conditions_.minimal(std::move(condition)))
      effects.push_back({alternative, changed.first, changed.second});
  }
  return effects;
}

void OperatorBuilder::addGroup(Group group) {
  const std::size_t first = group[0];  // effects are reached after their action
  try {
    Alternatives preconditions;
    std::size_t actions = 0;
    for (const std::size_t instantiation : group) {
      pollLimits();
      if (!isAction(instantiation)) continue;
      enter(instantiation);
      append(preconditions, conditionOf(instantiation));
      ++actions;
    }
    if (actions > 1) preconditions = conditions_.minimal(std::move(preconditions));
    if (preconditions.empty()) return;
    const std::vector<ConditionalEffect> effects = groundEffects(group);
    enter(first);
    for (FactSet& precondition : preconditions) {
      pollLimits();
      addOperator(first, std::move(precondition), effects);
    }
  } catch (const TooManyAlternatives&) {
    throw pddl::UnsupportedError(
        model_.domain_source, {},
        "not supported yet: more than " + std::to_string(TooManyAlternatives::kMost) +
            " alternatives in the conditions of action " + inQuotes(schemaOf(first).name.spelling));
  }
}

/// Leaves out of the condition what holds anyway; false where it can't hold.
bool OperatorBuilder::assume(const FactSet& precondition, FactSet& condition) const {
  const FactSet both = task::unite(precondition, condition);
  subtract(condition, precondition);
  return !conditions_.contradicts(both);
}

void OperatorBuilder::addOperator(std::size_t instantiation, FactSet precondition,
                                  const std::vector<ConditionalEffect>& effects) {
  const Schema& schema = schemaOf(instantiation);
  Operator op;
  op.precondition = std::move(precondition);
  op.add = reachedAtoms(schema.add);
  op.del = reachedAtoms(schema.del);
  for (const ConditionalEffect& each : effects) {
    ConditionalEffect effect = each;
    if (!assume(op.precondition, effect.condition)) continue;
    if (effect.condition.empty()) {
      insert(op.add, effect.add);
      insert(op.del, effect.del);
    } else {
      op.conditional.push_back(std::move(effect));
    }
  }
  letAddsWin(op);
  op.cost = cost(instantiation);
  op.name.name = schema.name.name;
  const auto& arguments = reached_.instantiations[instantiation].arguments;
  op.name.arguments.reserve(schema.parameters.size());
  for (std::size_t i = 0; i < schema.parameters.size(); ++i) {
    const auto object = static_cast<std::size_t>(arguments[i]);
    op.name.arguments.push_back(model_.objects[object].name.name);
  }
  account(op);
  operators_.push_back(std::move(op));
}

/// What an unconditional effect does anyway, conditional ones need not say, nor undo.
void OperatorBuilder::letAddsWin(Operator& op) const {
  subtract(op.del, op.add);
  for (ConditionalEffect& effect : op.conditional) {
    subtract(effect.add, op.add);
    subtract(effect.del, op.add);
    subtract(effect.del, op.del);
  }
  op.conditional.erase(std::remove_if(op.conditional.begin(), op.conditional.end(),
                                      [](const ConditionalEffect& effect) {
                                        return effect.add.empty() && effect.del.empty();
                                      }),
                       op.conditional.end());
}

/// Where a condition decides whether an atom is added after it was deleted, its complement depends
/// on the condition's negation, which may need complements in turn.
void OperatorBuilder::completeComplements() {
  for (bool again = true; again;) {
    again = false;
    for (const Operator& op : operators_) {
      pollLimits();
      again = completeComplements(op) || again;
    }
  }
}

bool OperatorBuilder::completeComplements(const Operator& op) {
  const std::size_t before = facts_.facts().size();
  FactSet deleted = op.del;
  for (const ConditionalEffect& effect : op.conditional)
    deleted.insert(deleted.end(), effect.del.begin(), effect.del.end());
  deleted = task::makeFactSet(std::move(deleted));
  for (const ConditionalEffect& adding : op.conditional) {
    const bool negated = std::any_of(adding.add.begin(), adding.add.end(), [&](AtomId atom) {
      return facts_.complement(atom) != kNoFact && task::has(deleted, atom);
    });
    if (!negated) continue;
    for (const task::FactId fact : adding.condition)
      facts_.addOpposite(fact);
  }
  return facts_.facts().size() > before;
}

/// AtomIds to facts, complementary ones included: such a fact is deleted where the atom is added,
/// and added where the atom is deleted and not added.
void OperatorBuilder::writeEffects(Operator& op) {
  const Operator drafted = std::move(op);
  op = Operator{drafted.name, drafted.precondition, {}, {}, drafted.cost, {}};
  const auto to_facts = [this](const FactSet& atoms) {
    FactSet facts;
    for (const AtomId atom : atoms)
      facts.push_back(facts_.fact(atom));
    return facts;
  };
  op.add = to_facts(drafted.add);
  op.del = to_facts(drafted.del);
  std::map<AtomId, Touch> touched;  // of the atoms with complements
  const auto touch = [&](const FactSet& atoms, std::vector<std::size_t> Touch::*by, std::size_t e) {
    for (const AtomId atom : atoms) {
      if (facts_.complement(atom) != kNoFact) (touched[atom].*by).push_back(e);
    }
  };
  touch(drafted.add, &Touch::added_by, kAlways);
  touch(drafted.del, &Touch::deleted_by, kAlways);
  for (std::size_t e = 0; e < drafted.conditional.size(); ++e) {
    const ConditionalEffect& effect = drafted.conditional[e];
    op.conditional.push_back({effect.condition, to_facts(effect.add), to_facts(effect.del)});
    touch(effect.add, &Touch::added_by, e);
    touch(effect.del, &Touch::deleted_by, e);
  }
  for (const auto& [atom, by] : touched) {
    pollLimits();
    writeComplement(facts_.complement(atom), by, drafted, op);
  }
  // Effects of one condition become one.
  std::map<FactSet, ConditionalEffect> merged;
  for (ConditionalEffect& effect : op.conditional) {
    ConditionalEffect& into = merged[effect.condition];
    into.condition = effect.condition;
    insert(into.add, effect.add);
    insert(into.del, effect.del);
  }
  op.conditional.clear();
  for (auto& [condition, effect] : merged) {
    subtract(effect.del, effect.add);
    op.conditional.push_back(std::move(effect));
  }
  op.add = task::makeFactSet(std::move(op.add));
  op.del = task::makeFactSet(std::move(op.del));
}

void OperatorBuilder::writeComplement(task::FactId complement, const Touch& by,
                                      const Operator& drafted, Operator& op) {
  const auto condition_of = [&](std::size_t effect) {
    return effect == kAlways ? FactSet{} : drafted.conditional[effect].condition;
  };
  for (const std::size_t effect : by.added_by)
    (effect == kAlways ? op.del : op.conditional[effect].del).push_back(complement);
  Alternatives deleted;
  for (const std::size_t effect : by.deleted_by)
    deleted.push_back(condition_of(effect));
  if (deleted.empty()) return;
  try {
    Alternatives not_added(1);
    for (const std::size_t effect : by.added_by) {
      not_added = conditions_.conjunction(not_added, conditions_.negation(condition_of(effect)));
    }
    for (FactSet& condition : conditions_.conjunction(deleted, not_added)) {
      if (!assume(op.precondition, condition)) continue;
      if (condition.empty()) {
        op.add.push_back(complement);
      } else {
        op.conditional.push_back({condition, {complement}, {}});
      }
    }
  } catch (const TooManyAlternatives&) {
    throw pddl::UnsupportedError(
        model_.domain_source, {},
        "not supported yet: more than " + std::to_string(TooManyAlternatives::kMost) +
            " alternatives in the effects of action " + inQuotes(drafted.name.name));
  }
}

task::Cost OperatorBuilder::cost(std::size_t instantiation) const {
  const Schema& action = schemaOf(instantiation);
  if (options_.unit_costs || !model_.has_costs) return 1;
  task::Cost cost = action.constant_cost;
  for (const pddl::LiftedAtom& function : action.function_costs)
    cost += valueOf(action, conditions_.atom(function));
  return cost;
}

task::Cost OperatorBuilder::valueOf(const Schema& action, const pddl::Atom& function) const {
  const auto value = model_.function_values.find(function);
  if (value != model_.function_values.end()) return value->second;
  std::string text = "(" + model_.functions[static_cast<std::size_t>(function.predicate)].name.name;
  for (const pddl::ObjectId object : function.objects)
    text += " " + model_.objects[static_cast<std::size_t>(object)].name.spelling;
  throw pddl::SemanticError(model_.problem_source, {},
                            "the cost of action '" + action.name.spelling + "' needs a value of " +
                                text + "), which :init does not give");
}

/// Alternatives and conditional effects may take far more than what was reached.
void OperatorBuilder::account(const Operator& op) {
  std::size_t ids = op.precondition.size() + op.add.size() + op.del.size();
  for (const ConditionalEffect& effect : op.conditional)
    ids += effect.condition.size() + effect.add.size() + effect.del.size();
  bytes_ += sizeof(Operator) + op.conditional.size() * sizeof(ConditionalEffect) +
            ids * sizeof(std::uint32_t);
  if (bytes_ > limits_.bytes) throw LimitReached(LimitReason::Memory, "grounding");
}

void OperatorBuilder::pollLimits() {
  pollOrThrow(monitor_, "grounding");
}

}  // namespace goal_alignment::grounding
