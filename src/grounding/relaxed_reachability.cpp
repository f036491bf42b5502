// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/grounding/relaxed_reachability.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "atom_index.h"
#include "domains.h"
#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::grounding {

using pddl::Atom;
using pddl::AtomView;
using pddl::Formula;
using pddl::LiftedAtom;
using pddl::Model;
using pddl::ObjectId;
using pddl::PredicateId;
using pddl::Schema;
using pddl::Term;

namespace {

constexpr std::size_t kAccountedBytesPerAtom = 160;
constexpr std::size_t kAccountedBytesPerInstantiation = 64;
constexpr AtomId kNoAtom = pddl::AtomTable::kNone;
constexpr std::size_t kNoTrigger = std::numeric_limits<std::size_t>::max();

/// A rule as the join needs it.
struct Plan {
  const Rule* rule = nullptr;
  std::vector<std::shared_ptr<const Domain>> domains;  // in the order of Rule::variables
  std::vector<int> free;  // variables that no atom of the body mentions
  std::vector<int> kept;  // variables whose objects make a difference to what can change
  pddl::AtomTable found;  // what they were, where they are not all; as atoms of no predicate
};

/// One run of the fixpoint.
class Join {
 public:
  Join(const Model& model, const Limits& limits)
      : model_(model),
        limits_(limits),
        monitor_(limits),
        predicates_(model.predicates.size() + model.schemas.size()),
        index_(result_.atoms, predicates_, limits),
        occurrences_(predicates_),
        deletable_(predicates_, false) {
    result_.rules = compileRules(model, limits);
    const auto note = [this](const std::vector<LiftedAtom>& deleted) {
      for (const LiftedAtom& atom : deleted)
        deletable_[static_cast<std::size_t>(atom.predicate)] = true;
    };
    std::size_t variables = 0;
    for (const Schema& schema : model.schemas) {
      variables = std::max(variables, schema.parameters.size() + schema.quantified.size());
      note(schema.del);
      for (const pddl::ConditionalEffect& effect : schema.conditional)
        note(effect.del);
    }
    domain_.resize(variables);
    binding_.resize(variables, kUnbound);
  }

  RelaxedReachability run() {
    internInitialAtoms();
    AtomId id = 0;
    for (; id < result_.initial_count && isStatic(result_.atoms[id].predicate); ++id)
      index_.insert(id);
    makePlans();
    for (const Plan& plan : plans_) {
      const auto& body = plan.rule->body;
      const bool triggered = std::any_of(
          body.begin(), body.end(), [this](const auto& atom) { return !isStatic(atom.predicate); });
      if (triggered) continue;
      start(static_cast<std::size_t>(&plan - plans_.data()), kNoTrigger);
      extend();
    }
    for (; id < result_.atoms.size(); ++id) {
      trigger(id);
    }
    forgetReachedActions();
    return std::move(result_);
  }

 private:
  struct Occurrence {
    std::size_t plan;
    std::size_t position;  // in the body
  };

  bool isStatic(PredicateId predicate) const {
    const auto p = static_cast<std::size_t>(predicate);
    return p < model_.predicates.size() && !model_.predicates[p].fluent;
  }

  void internInitialAtoms() {
    for (const bool fluent : {false, true}) {
      for (const Atom& atom : model_.init) {
        checkLimits();
        if (isStatic(atom.predicate) != fluent) intern(atom);
      }
    }
    result_.initial_count = result_.atoms.size();
  }

  void makePlans() {
    Domains domains(model_, result_.atoms, index_, limits_);
    for (const Rule& rule : result_.rules) {
      Plan plan;
      checkLimits();
      plan.domains = domains.of(rule);
      if (plan.domains.size() < rule.variables.size()) continue;
      const Schema& schema = model_.schemas[static_cast<std::size_t>(rule.schema)];
      plan.rule = &rule;
      sortVariables(plan, schema);
      for (std::size_t i = 0; i < rule.body.size(); ++i) {
        const LiftedAtom& atom = rule.body[i];
        if (isStatic(atom.predicate)) continue;
        occurrences_[static_cast<std::size_t>(atom.predicate)].push_back({plans_.size(), i});
      }
      plans_.push_back(std::move(plan));
    }
  }

  /// Fills `free` and `kept`.
  void sortVariables(Plan& plan, const Schema& schema) const {
    const Rule& rule = *plan.rule;
    const std::size_t variables = schema.parameters.size() + schema.quantified.size();
    std::vector<bool> in_body(variables, false);
    std::vector<bool> matters(variables, !rule.residual.empty());
    std::fill_n(matters.begin(), schema.parameters.size(), true);
    const auto note = [](const std::vector<LiftedAtom>& atoms, std::vector<bool>& into, auto&& of) {
      for (const LiftedAtom& atom : atoms) {
        for (const Term& term : atom.terms) {
          if (term.is_parameter && of(atom)) into[static_cast<std::size_t>(term.index)] = true;
        }
      }
    };
    const auto any = [](const LiftedAtom&) { return true; };
    const auto fluent = [this](const LiftedAtom& atom) { return !isStatic(atom.predicate); };
    note(rule.body, in_body, any);
    note(rule.body, matters, fluent);
    note(rule.absent, matters, fluent);
    note(rule.head, matters, any);
    if (rule.effect != Rule::kAction) note(schema.conditional[rule.effect].del, matters, any);
    for (const int variable : rule.variables) {
      if (!in_body[static_cast<std::size_t>(variable)]) plan.free.push_back(variable);
      if (matters[static_cast<std::size_t>(variable)]) plan.kept.push_back(variable);
    }
  }

  void checkLimits() {
    LimitReason reason = monitor_.poll();
    const std::size_t bytes = result_.atoms.size() * kAccountedBytesPerAtom +
                              result_.instantiations.size() * kAccountedBytesPerInstantiation +
                              arguments_ * sizeof(ObjectId) + index_.bytes();
    if (bytes > limits_.bytes) reason = LimitReason::Memory;
    throwIfReached(reason, "grounding");
  }

  void intern(const Atom& atom) {
    if (result_.atoms.insert(atom).second) arguments_ += atom.objects.size();
  }

  /// Makes the atom visible, and matches it with every atom of a body that it may serve.
  void trigger(AtomId id) {
    checkLimits();
    const AtomView atom = result_.atoms[id];
    const auto& occurrences = occurrences_[static_cast<std::size_t>(atom.predicate)];
    if (occurrences.empty()) return;  // nobody will look for it
    index_.insert(id);
    newest_ = id;
    for (const Occurrence& at : occurrences) {
      checkLimits();
      ++result_.match_attempts;
      start(at.plan, at.position);
      matched_[at.position] = true;
      const std::size_t mark = trail_.size();
      if (match(plan_->rule->body[at.position], atom)) extend();
      undo(mark);
    }
  }

  void start(std::size_t plan, std::size_t triggered_by) {
    plan_ = &plans_[plan];
    triggered_by_ = triggered_by;
    for (std::size_t i = 0; i < plan_->domains.size(); ++i)
      domain_[static_cast<std::size_t>(plan_->rule->variables[i])] = plan_->domains[i].get();
    matched_.assign(plan_->rule->body.size(), false);
  }

  /// Binds one variable; false where its domain or an equality forbids the object.
  bool bindVariable(int variable, ObjectId object) {
    const auto v = static_cast<std::size_t>(variable);
    if (!(*domain_[v])[static_cast<std::size_t>(object)]) return false;
    binding_[v] = object;
    trail_.push_back(v);
    return std::all_of(plan_->rule->equalities.begin(), plan_->rule->equalities.end(),
                       [this](const pddl::Equality& equality) {
                         const ObjectId left = value(equality.left);
                         const ObjectId right = value(equality.right);
                         if (left == kUnbound || right == kUnbound) return true;
                         return (left == right) != equality.negated;
                       });
  }

  ObjectId value(const Term& term) const {
    return term.is_parameter ? binding_[static_cast<std::size_t>(term.index)] : term.index;
  }

  bool match(const LiftedAtom& lifted, const AtomView& atom) {
    for (std::size_t i = 0; i < lifted.terms.size(); ++i) {
      const ObjectId bound = value(lifted.terms[i]);
      if (bound == atom.objects[i]) continue;
      if (bound != kUnbound || !bindVariable(lifted.terms[i].index, atom.objects[i])) return false;
    }
    return true;
  }

  void undo(std::size_t mark) {
    for (; trail_.size() > mark; trail_.pop_back())
      binding_[trail_.back()] = kUnbound;
  }

  /// The unmatched atom of the body with the fewest matches, and these; kNoTrigger: all matched.
  std::pair<std::size_t, const std::vector<AtomId>*> mostConstrained() {
    std::size_t next = kNoTrigger;
    const std::vector<AtomId>* atoms = nullptr;
    for (std::size_t i = 0; i < matched_.size(); ++i) {
      if (matched_[i]) continue;
      const auto& candidates = index_.matching(plan_->rule->body[i], binding_);
      if (atoms != nullptr && candidates.size() >= atoms->size()) continue;
      next = i;
      atoms = &candidates;
      if (atoms->empty()) break;
    }
    return {next, atoms};
  }

  void extend() {
    const auto [next, atoms] = mostConstrained();
    if (next == kNoTrigger) {
      bindFree(0);
      return;
    }
    const LiftedAtom& lifted = plan_->rule->body[next];
    matched_[next] = true;
    for (const AtomId id : *atoms) {
      // Atoms before the trigger take older ones only, so that an instantiation that uses the
      // newest atom twice is found once.
      if (id == newest_ && next < triggered_by_) continue;
      checkLimits();
      ++result_.match_attempts;
      const std::size_t mark = trail_.size();
      if (match(lifted, result_.atoms[id])) extend();
      undo(mark);
    }
    matched_[next] = false;
  }

  void bindFree(std::size_t from) {
    if (from == plan_->free.size()) {
      instantiate();
      return;
    }
    const int variable = plan_->free[from];
    const Domain& domain = *domain_[static_cast<std::size_t>(variable)];
    for (std::size_t o = 0; o < domain.size(); ++o) {
      checkLimits();
      if (!domain[o]) continue;
      ++result_.match_attempts;
      const std::size_t mark = trail_.size();
      if (bindVariable(variable, static_cast<ObjectId>(o))) bindFree(from + 1);
      undo(mark);
    }
  }

  bool initially(const LiftedAtom& atom) const {
    const AtomId found = result_.atoms.find(groundAtom(atom, binding_));
    return found != kNoAtom && found < result_.initial_count;
  }

  bool maybeFalse(const LiftedAtom& atom) const {
    return deletable_[static_cast<std::size_t>(atom.predicate)] || !initially(atom);
  }

  /// Whether the formula holds when of what can change every literal does. As long as the
  /// universal quantifiers' objects are many.
  bool maybeHolds(const Formula& formula) {
    const auto maybe = [this](const Formula& part) { return maybeHolds(part); };
    switch (formula.kind) {
      case Formula::Kind::Literal: {
        const LiftedAtom& atom = formula.literal.atom;
        if (formula.literal.negated) return maybeFalse(atom);
        return !isStatic(atom.predicate) || initially(atom);
      }
      case Formula::Kind::Equality:
        return (value(formula.equality.left) == value(formula.equality.right)) !=
               formula.equality.negated;
      case Formula::Kind::And:
        return std::all_of(formula.parts.begin(), formula.parts.end(), maybe);
      case Formula::Kind::Or:
        return std::any_of(formula.parts.begin(), formula.parts.end(), maybe);
      case Formula::Kind::ForAll:
        return !anyBinding(formula, 0, false);
      case Formula::Kind::Exists:
        return anyBinding(formula, 0, true);
    }
    return true;
  }

  /// Whether the quantifier's part is `wanted` under some binding of its variables.
  bool anyBinding(const Formula& formula, std::size_t from, bool wanted) {
    if (from == formula.variables.size()) return maybeHolds(formula.parts.front()) == wanted;
    const int variable = formula.variables[from];
    const Schema& schema = model_.schemas[static_cast<std::size_t>(plan_->rule->schema)];
    const pddl::TypeId type = variableOf(schema, variable).type;
    ObjectId& bound = binding_[static_cast<std::size_t>(variable)];
    bool found = false;
    for (std::size_t o = 0; o < model_.objects.size() && !found; ++o) {
      checkLimits();
      if (!model_.isSubtype(model_.objects[o].type, type)) continue;
      bound = static_cast<ObjectId>(o);
      found = anyBinding(formula, from + 1, wanted);
    }
    bound = kUnbound;
    return found;
  }

  /// The objects of these variables, until the next call.
  Span<ObjectId> bound(const std::vector<int>& variables) {
    bound_.clear();
    for (const int variable : variables)
      bound_.push_back(binding_[static_cast<std::size_t>(variable)]);
    return bound_;
  }

  /// False where another binding has made the same difference already.
  bool isNew() {
    if (plan_->kept.size() == plan_->rule->variables.size()) return true;
    const bool is_new = plan_->found.insert({0, bound(plan_->kept)}).second;
    if (is_new) arguments_ += plan_->kept.size();
    return is_new;
  }

  void instantiate() {
    const Rule& rule = *plan_->rule;
    for (const pddl::Equality& equality : rule.equalities) {
      if ((value(equality.left) == value(equality.right)) == equality.negated) return;
    }
    for (const LiftedAtom& atom : rule.absent) {
      if (!maybeFalse(atom)) return;
    }
    for (const Formula* formula : rule.residual) {
      if (!maybeHolds(*formula)) return;
    }
    if (!isNew()) return;
    result_.instantiations.push_back({static_cast<std::size_t>(&rule - result_.rules.data()),
                                      result_.arguments.keep(bound(rule.variables))});
    arguments_ += rule.variables.size();
    for (const LiftedAtom& atom : rule.head)
      intern(groundAtom(atom, binding_));
  }

  /// The atoms that tied effects to their actions are no part of the result.
  void forgetReachedActions() {
    const auto is_action = [this](const AtomView& atom) {
      return static_cast<std::size_t>(atom.predicate) >= model_.predicates.size();
    };
    const auto conditional = [](const Schema& schema) { return !schema.conditional.empty(); };
    if (std::none_of(model_.schemas.begin(), model_.schemas.end(), conditional)) return;
    pddl::AtomTable atoms;
    for (const AtomView atom : result_.atoms) {
      checkLimits();
      if (!is_action(atom)) atoms.insert(atom);
    }
    result_.atoms = std::move(atoms);
  }

  const Model& model_;
  Limits limits_;
  LimitMonitor monitor_;
  std::size_t predicates_;
  RelaxedReachability result_;
  AtomIndex index_;
  std::vector<std::vector<Occurrence>> occurrences_;
  std::vector<bool> deletable_;
  std::vector<Plan> plans_;
  std::size_t arguments_ = 0;  // objects that are held in all

  // The instantiation under construction. Between two of them nothing is bound.
  AtomId newest_ = kNoAtom;
  Plan* plan_ = nullptr;
  std::size_t triggered_by_ = 0;
  std::vector<const Domain*> domain_;  // by variable, where the rule has it
  std::vector<ObjectId> binding_;
  std::vector<ObjectId> bound_;
  std::vector<std::size_t> trail_;
  std::vector<bool> matched_;
};

}  // namespace

Atom groundAtom(const LiftedAtom& atom, const std::vector<ObjectId>& binding) {
  Atom ground;
  ground.predicate = atom.predicate;
  ground.objects.reserve(atom.terms.size());
  for (const Term& term : atom.terms) {
    ground.objects.push_back(term.is_parameter ? binding[static_cast<std::size_t>(term.index)]
                                               : term.index);
  }
  return ground;
}

void bind(const Rule& rule, Span<ObjectId> arguments, std::vector<ObjectId>& binding) {
  for (std::size_t i = 0; i < arguments.size(); ++i)
    binding[static_cast<std::size_t>(rule.variables[i])] = arguments[i];
}

RelaxedReachability relaxedReachability(const Model& model, const Limits& limits) {
  return Join(model, limits).run();
}

}  // namespace goal_alignment::grounding
