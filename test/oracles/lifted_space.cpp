// SPDX-License-Identifier: BSD-3-Clause
#include "oracles/lifted_space.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace goal_alignment::oracles {

using pddl::Model;
using pddl::ObjectId;

namespace {

using Binding = std::vector<ObjectId>;

ObjectId valueOf(const pddl::Term& term, const Binding& binding) {
  return term.is_parameter ? binding.at(static_cast<std::size_t>(term.index)) : term.index;
}

GroundName groundAtom(const Model& model, const pddl::LiftedAtom& lifted, const Binding& binding) {
  GroundName name{model.predicates.at(static_cast<std::size_t>(lifted.predicate)).name.name, {}};
  for (const pddl::Term& term : lifted.terms) {
    const ObjectId object = valueOf(term, binding);
    name.arguments.push_back(model.objects.at(static_cast<std::size_t>(object)).name.name);
  }
  return name;
}

/// Spells out what a formula means under a binding of its variables.
class Spelling {
 public:
  Spelling(const Model& model, const std::vector<pddl::Parameter>& parameters,
           const std::vector<pddl::Parameter>& quantified)
      : model_(model), variables_(parameters) {
    variables_.insert(variables_.end(), quantified.begin(), quantified.end());
  }

  GroundFormula of(const pddl::Formula& formula, Binding binding) const {
    using Kind = pddl::Formula::Kind;
    GroundFormula ground;
    binding.resize(variables_.size());
    switch (formula.kind) {
      case Kind::Literal:
        ground.kind = GroundFormula::Kind::Literal;
        ground.literal = {groundAtom(model_, formula.literal.atom, binding),
                          formula.literal.negated};
        break;
      case Kind::Equality: {
        const bool same =
            valueOf(formula.equality.left, binding) == valueOf(formula.equality.right, binding);
        const bool holds = same != formula.equality.negated;
        ground.kind = holds ? GroundFormula::Kind::All : GroundFormula::Kind::Any;
        break;
      }
      case Kind::And:
      case Kind::Or:
        ground.kind =
            formula.kind == Kind::And ? GroundFormula::Kind::All : GroundFormula::Kind::Any;
        for (const pddl::Formula& part : formula.parts)
          ground.parts.push_back(of(part, binding));
        break;
      case Kind::ForAll:
      case Kind::Exists:
        ground.kind =
            formula.kind == Kind::ForAll ? GroundFormula::Kind::All : GroundFormula::Kind::Any;
        for (const Binding& bound : bindings(formula.variables, binding))
          ground.parts.push_back(of(formula.parts.at(0), bound));
        break;
    }
    return ground;
  }

  /// Every way to bind the variables to objects of their types, the others staying as they are.
  std::vector<Binding> bindings(const std::vector<int>& variables, Binding binding) const {
    binding.resize(variables_.size());
    std::vector<Binding> all = {binding};
    for (const int variable : variables) {
      const auto v = static_cast<std::size_t>(variable);
      std::vector<Binding> longer;
      for (Binding each : all) {
        for (std::size_t object = 0; object < model_.objects.size(); ++object) {
          if (!model_.isSubtype(model_.objects[object].type, variables_.at(v).type)) continue;
          each.at(v) = static_cast<ObjectId>(object);
          longer.push_back(each);
        }
      }
      all = std::move(longer);
    }
    return all;
  }

 private:
  const Model& model_;
  std::vector<pddl::Parameter> variables_;
};

bool equalitiesHold(const pddl::Schema& schema, const Binding& binding) {
  return std::all_of(schema.equalities.begin(), schema.equalities.end(), [&](const auto& equality) {
    return (valueOf(equality.left, binding) == valueOf(equality.right, binding)) !=
           equality.negated;
  });
}

std::int64_t costOf(const Model& model, const pddl::Schema& schema, const Binding& binding) {
  if (!model.has_costs) return 1;
  std::int64_t cost = schema.constant_cost;
  for (const pddl::LiftedAtom& function : schema.function_costs) {
    pddl::Atom term{function.predicate, {}};
    for (const pddl::Term& argument : function.terms)
      term.objects.push_back(valueOf(argument, binding));
    cost += model.function_values.at(term);
  }
  return cost;
}

GroundAction instantiate(const Model& model, const pddl::Schema& schema, const Binding& binding) {
  GroundAction action;
  action.name.name = schema.name.name;
  for (const ObjectId object : binding) {
    action.name.arguments.push_back(model.objects.at(static_cast<std::size_t>(object)).name.name);
  }
  for (const pddl::LiftedLiteral& literal : schema.precondition) {
    action.precondition.push_back({groundAtom(model, literal.atom, binding), literal.negated});
  }
  for (const auto& atom : schema.add)
    action.add.insert(groundAtom(model, atom, binding));
  for (const auto& atom : schema.del)
    action.del.insert(groundAtom(model, atom, binding));
  const Spelling spelling(model, schema.parameters, schema.quantified);
  action.condition = spelling.of(schema.condition, binding);
  for (const pddl::ConditionalEffect& effect : schema.conditional) {
    for (const Binding& bound : spelling.bindings(effect.variables, binding)) {
      GroundEffect ground{spelling.of(effect.condition, bound), {}, {}};
      for (const auto& atom : effect.add)
        ground.add.insert(groundAtom(model, atom, bound));
      for (const auto& atom : effect.del)
        ground.del.insert(groundAtom(model, atom, bound));
      action.conditional.push_back(std::move(ground));
    }
  }
  action.cost = costOf(model, schema, binding);
  return action;
}

void bindFrom(const Model& model, const pddl::Schema& schema, Binding& binding,
              std::vector<GroundAction>& actions) {
  if (binding.size() == schema.parameters.size()) {
    if (equalitiesHold(schema, binding)) actions.push_back(instantiate(model, schema, binding));
    return;
  }
  const pddl::TypeId type = schema.parameters[binding.size()].type;
  for (std::size_t object = 0; object < model.objects.size(); ++object) {
    if (!model.isSubtype(model.objects[object].type, type)) continue;
    binding.push_back(static_cast<ObjectId>(object));
    bindFrom(model, schema, binding, actions);
    binding.pop_back();
  }
}

}  // namespace

Atoms initialAtoms(const Model& model) {
  Atoms atoms;
  for (const pddl::Atom& atom : model.init)
    atoms.insert(model.name(atom));
  return atoms;
}

std::vector<GroundAction> allActions(const Model& model) {
  std::vector<GroundAction> actions;
  Binding binding;
  for (const pddl::Schema& schema : model.schemas)
    bindFrom(model, schema, binding, actions);
  return actions;
}

bool holds(const std::vector<Literal>& literals, const Atoms& atoms) {
  return std::all_of(literals.begin(), literals.end(), [&](const Literal& literal) {
    return (atoms.count(literal.atom) > 0) != literal.negated;
  });
}

bool holds(const GroundFormula& formula, const Atoms& atoms) {
  const auto part_holds = [&](const GroundFormula& part) { return holds(part, atoms); };
  const auto& parts = formula.parts;
  if (formula.kind == GroundFormula::Kind::Literal) return holds({formula.literal}, atoms);
  return formula.kind == GroundFormula::Kind::All
             ? std::all_of(parts.begin(), parts.end(), part_holds)
             : std::any_of(parts.begin(), parts.end(), part_holds);
}

GroundFormula goalCondition(const Model& model) {
  return Spelling(model, {}, model.goal_variables).of(model.goal_condition, {});
}

bool applicable(const GroundAction& action, const Atoms& atoms) {
  return holds(action.precondition, atoms) && holds(action.condition, atoms);
}

Atoms successor(const GroundAction& action, const Atoms& atoms) {
  Atoms deleted = action.del;
  Atoms added = action.add;
  for (const GroundEffect& effect : action.conditional) {
    if (!holds(effect.condition, atoms)) continue;
    deleted.insert(effect.del.begin(), effect.del.end());
    added.insert(effect.add.begin(), effect.add.end());
  }
  Atoms after = atoms;
  for (const GroundName& atom : deleted)
    after.erase(atom);
  after.insert(added.begin(), added.end());
  return after;
}

RelaxedGrounding groundNaively(const Model& model) {
  std::set<std::string> deleted_predicates;
  const std::vector<GroundAction> all = allActions(model);
  for (const pddl::Schema& schema : model.schemas) {
    for (const pddl::LiftedAtom& atom : schema.del) {
      deleted_predicates.insert(
          model.predicates.at(static_cast<std::size_t>(atom.predicate)).name.name);
    }
  }
  const Atoms initial = initialAtoms(model);
  RelaxedGrounding result{initial, {}};
  const auto may_hold = [&](const Literal& literal) {
    if (!literal.negated) return result.atoms.count(literal.atom) > 0;
    return initial.count(literal.atom) == 0 || deleted_predicates.count(literal.atom.name) > 0;
  };
  std::set<GroundName> taken;
  for (bool changed = true; changed;) {
    changed = false;
    for (const GroundAction& action : all) {
      if (taken.count(action.name) > 0) continue;
      if (!std::all_of(action.precondition.begin(), action.precondition.end(), may_hold)) continue;
      taken.insert(action.name);
      result.actions.push_back(action);
      result.atoms.insert(action.add.begin(), action.add.end());
      changed = true;
    }
  }
  return result;
}

LiftedSpace::LiftedSpace(const Model& model, std::size_t most_states, bool unit_costs) {
  const CandidateMask initial = bits(initialAtoms(model));
  for (const GroundAction& action : allActions(model))
    actions_.push_back(bitAction(action, unit_costs));
  std::set<std::pair<std::int64_t, CandidateMask>> open = {{0, initial}};
  while (!open.empty()) {
    const auto [cost, state] = *open.begin();
    open.erase(open.begin());
    if (!cost_.emplace(state, cost).second) continue;
    complete_ = cost_.size() <= most_states;
    if (!complete_) return;
    for (const BitAction& action : actions_) {
      if (!applicable(action, state)) continue;
      const CandidateMask after = successor(action, state);
      if (cost_.count(after) == 0) open.emplace(cost + action.cost, after);
    }
  }
}

bool LiftedSpace::holds(const BitFormula& formula, CandidateMask state) {
  const auto part_holds = [&](const BitFormula& part) { return holds(part, state); };
  const auto& parts = formula.parts;
  if (formula.kind == GroundFormula::Kind::Literal) {
    return ((state & formula.bit) != 0) != formula.negated;
  }
  return formula.kind == GroundFormula::Kind::All
             ? std::all_of(parts.begin(), parts.end(), part_holds)
             : std::any_of(parts.begin(), parts.end(), part_holds);
}

bool LiftedSpace::applicable(const BitAction& action, CandidateMask state) {
  return (state & action.positive) == action.positive && (state & action.negative) == 0 &&
         holds(action.condition, state);
}

LiftedSpace::CandidateMask LiftedSpace::successor(const BitAction& action, CandidateMask state) {
  CandidateMask del = action.del;
  CandidateMask add = action.add;
  for (const BitEffect& effect : action.conditional) {
    if (!holds(effect.condition, state)) continue;
    del |= effect.del;
    add |= effect.add;
  }
  return (state & ~del) | add;
}

LiftedSpace::CandidateMask LiftedSpace::bits(const Atoms& atoms) {
  CandidateMask all = 0;
  for (const GroundName& atom : atoms)
    all |= bit(atom);
  return all;
}

LiftedSpace::BitFormula LiftedSpace::bitFormula(const GroundFormula& formula) {
  BitFormula compiled;
  compiled.kind = formula.kind;
  compiled.negated = formula.literal.negated;
  if (formula.kind == GroundFormula::Kind::Literal) compiled.bit = bit(formula.literal.atom);
  for (const GroundFormula& part : formula.parts)
    compiled.parts.push_back(bitFormula(part));
  return compiled;
}

LiftedSpace::BitAction LiftedSpace::bitAction(const GroundAction& action, bool unit_costs) {
  BitAction compiled;
  for (const Literal& literal : action.precondition) {
    (literal.negated ? compiled.negative : compiled.positive) |= bit(literal.atom);
  }
  compiled.condition = bitFormula(action.condition);
  compiled.add = bits(action.add);
  compiled.del = bits(action.del);
  for (const GroundEffect& effect : action.conditional) {
    compiled.conditional.push_back(
        {bitFormula(effect.condition), bits(effect.add), bits(effect.del)});
  }
  compiled.cost = unit_costs ? 1 : action.cost;
  return compiled;
}

LiftedSpace::CandidateMask LiftedSpace::bit(const GroundName& atom) {
  const std::size_t next = index_.size();
  const std::size_t index = index_.emplace(atom, next).first->second;
  if (index >= 64) throw std::length_error("too many atoms for the explicit state space");
  return CandidateMask{1} << index;
}

std::vector<Atoms> LiftedSpace::states() const {
  std::vector<Atoms> result;
  for (const auto& [state, cost] : cost_) {
    Atoms atoms;
    for (const auto& [atom, index] : index_) {
      if (((state >> index) & 1U) != 0) atoms.insert(atom);
    }
    result.push_back(std::move(atoms));
  }
  return result;
}

bool LiftedSpace::holds(const Literal& literal, CandidateMask state) const {
  const auto found = index_.find(literal.atom);
  const bool is_true = found != index_.end() && ((state >> found->second) & 1U) != 0;
  return is_true != literal.negated;
}

bool LiftedSpace::holds(const std::vector<Literal>& goal, CandidateMask state) const {
  return std::all_of(goal.begin(), goal.end(),
                     [&](const Literal& literal) { return holds(literal, state); });
}

std::optional<std::int64_t> LiftedSpace::cheapest(const std::vector<Literal>& goal) const {
  std::optional<std::int64_t> best;
  for (const auto& [state, cost] : cost_) {
    if (holds(goal, state) && (!best || cost < *best)) best = cost;
  }
  return best;
}

std::set<std::uint64_t> LiftedSpace::fluentsWith(const std::vector<Literal>& goal,
                                                 const std::vector<Literal>& fluents) const {
  std::set<std::uint64_t> result;
  for (const auto& [state, cost] : cost_) {
    if (!holds(goal, state)) continue;
    std::uint64_t present = 0;
    for (std::size_t f = 0; f < fluents.size(); ++f) {
      if (holds(fluents[f], state)) present |= std::uint64_t{1} << f;
    }
    result.insert(present);
  }
  return result;
}

}  // namespace goal_alignment::oracles
