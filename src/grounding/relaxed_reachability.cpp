// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/grounding/relaxed_reachability.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::grounding {

using pddl::Atom;
using pddl::LiftedAtom;
using pddl::Model;
using pddl::ObjectId;
using pddl::Schema;
using pddl::SchemaId;
using pddl::Term;

namespace {

constexpr ObjectId kUnbound = -1;
constexpr std::size_t kAccountedBytesPerAtom = 160;
constexpr std::size_t kAccountedBytesPerInstantiation = 64;

/// Atoms that have appeared, by predicate and by (predicate, argument position, object).
class AtomIndex {
 public:
  explicit AtomIndex(const Model& model) : objects_(model.objects.size()) {
    all_.resize(model.predicates.size());
    by_argument_.resize(model.predicates.size());
    for (std::size_t p = 0; p < model.predicates.size(); ++p) {
      by_argument_[p].resize(model.predicates[p].parameter_types.size() * objects_);
    }
  }

  void insert(const Atom& atom, AtomId id) {
    const auto p = static_cast<std::size_t>(atom.predicate);
    all_[p].push_back(id);
    for (std::size_t i = 0; i < atom.objects.size(); ++i) {
      by_argument_[p][i * objects_ + static_cast<std::size_t>(atom.objects[i])].push_back(id);
    }
  }

  /// The shortest list that holds every atom matching the lifted atom under the binding.
  const std::vector<AtomId>& candidates(const LiftedAtom& atom,
                                        const std::vector<ObjectId>& binding) const {
    const auto p = static_cast<std::size_t>(atom.predicate);
    const std::vector<AtomId>* best = &all_[p];
    for (std::size_t i = 0; i < atom.terms.size(); ++i) {
      const Term& term = atom.terms[i];
      const ObjectId object =
          term.is_parameter ? binding[static_cast<std::size_t>(term.index)] : term.index;
      if (object == kUnbound) continue;
      const auto& list = by_argument_[p][i * objects_ + static_cast<std::size_t>(object)];
      if (list.size() < best->size()) best = &list;
    }
    return *best;
  }

 private:
  std::size_t objects_;
  std::vector<std::vector<AtomId>> all_;
  std::vector<std::vector<std::vector<AtomId>>> by_argument_;
};

/// One run of the fixpoint.
class Join {
 public:
  Join(const Model& model, const Limits& limits)
      : model_(model), limits_(limits), monitor_(limits), index_(model) {
    indexTypes();
    occurrences_.resize(model.predicates.size());
    deletable_.assign(model.predicates.size(), false);
    for (std::size_t s = 0; s < model.schemas.size(); ++s) {
      const Schema& schema = model.schemas[s];
      for (const LiftedAtom& atom : schema.del) {
        deletable_[static_cast<std::size_t>(atom.predicate)] = true;
      }
      for (std::size_t i = 0; i < schema.precondition.size(); ++i) {
        if (schema.precondition[i].negated) continue;
        const auto p = static_cast<std::size_t>(schema.precondition[i].atom.predicate);
        occurrences_[p].push_back({static_cast<SchemaId>(s), i});
      }
    }
  }

  RelaxedReachability run() {
    for (const bool fluent : {false, true}) {
      for (const Atom& atom : model_.init) {
        if (model_.predicates[static_cast<std::size_t>(atom.predicate)].fluent == fluent)
          intern(atom);
      }
    }
    result_.initial_count = result_.atoms.size();
    for (std::size_t s = 0; s < model_.schemas.size(); ++s) {
      const auto& precondition = model_.schemas[s].precondition;
      const bool triggered = std::any_of(precondition.begin(), precondition.end(),
                                         [](const auto& literal) { return !literal.negated; });
      if (triggered) continue;
      start(static_cast<SchemaId>(s), std::numeric_limits<std::size_t>::max());
      extend();
    }
    for (AtomId id = 0; id < result_.atoms.size(); ++id) {
      index_.insert(result_.atoms[id], id);
      trigger(id);
    }
    return std::move(result_);
  }

 private:
  struct Occurrence {
    SchemaId schema;
    std::size_t precondition;
  };

  void indexTypes() {
    objects_of_.resize(model_.types.size());
    for (std::size_t o = 0; o < model_.objects.size(); ++o) {
      for (pddl::TypeId t = model_.objects[o].type; t != -1; t = model_.types[t].parent)
        objects_of_[static_cast<std::size_t>(t)].push_back(static_cast<ObjectId>(o));
    }
  }

  void checkLimits() {
    LimitReason reason = monitor_.poll();
    const std::size_t bytes = result_.atoms.size() * kAccountedBytesPerAtom +
                              result_.instantiations.size() * kAccountedBytesPerInstantiation;
    if (bytes > limits_.bytes) reason = LimitReason::Memory;
    if (reason != LimitReason::None) throw LimitReached(reason, "grounding");
  }

  void intern(const Atom& atom) {
    const auto id = static_cast<AtomId>(result_.atoms.size());
    if (result_.ids.emplace(atom, id).second) result_.atoms.push_back(atom);
  }

  /// Matches the newly visible atom with every precondition it may serve.
  void trigger(AtomId id) {
    newest_ = id;
    const Atom atom = result_.atoms[id];  // a copy: interning moves the vector
    for (const Occurrence& at : occurrences_[static_cast<std::size_t>(atom.predicate)]) {
      checkLimits();
      start(at.schema, at.precondition);
      matched_[at.precondition] = true;
      const std::size_t mark = trail_.size();
      if (match(schema_->precondition[at.precondition].atom, atom)) extend();
      undo(mark);
    }
  }

  void start(SchemaId schema, std::size_t triggered_by) {
    schema_id_ = schema;
    schema_ = &model_.schemas[static_cast<std::size_t>(schema)];
    triggered_by_ = triggered_by;
    binding_.assign(schema_->parameters.size(), kUnbound);
    trail_.clear();
    matched_.assign(schema_->precondition.size(), false);
    for (std::size_t i = 0; i < matched_.size(); ++i) {
      if (schema_->precondition[i].negated) matched_[i] = true;
    }
  }

  /// Binds one parameter; false where its type or an equality forbids the object.
  bool bindParameter(std::size_t parameter, ObjectId object) {
    if (!model_.isSubtype(model_.objects[object].type, schema_->parameters[parameter].type)) {
      return false;
    }
    binding_[parameter] = object;
    trail_.push_back(parameter);
    for (const pddl::Equality& equality : schema_->equalities) {
      const ObjectId left = value(equality.left);
      const ObjectId right = value(equality.right);
      if (left == kUnbound || right == kUnbound) continue;
      if ((left == right) == equality.negated) return false;
    }
    return true;
  }

  ObjectId value(const Term& term) const {
    return term.is_parameter ? binding_[static_cast<std::size_t>(term.index)] : term.index;
  }

  bool match(const LiftedAtom& lifted, const Atom& atom) {
    for (std::size_t i = 0; i < lifted.terms.size(); ++i) {
      const ObjectId bound = value(lifted.terms[i]);
      if (bound == atom.objects[i]) continue;
      if (bound != kUnbound) return false;
      if (!bindParameter(static_cast<std::size_t>(lifted.terms[i].index), atom.objects[i])) {
        return false;
      }
    }
    return true;
  }

  void undo(std::size_t mark) {
    for (; trail_.size() > mark; trail_.pop_back())
      binding_[trail_.back()] = kUnbound;
  }

  /// Matches the remaining preconditions, the one with the fewest candidates first.
  void extend() {
    std::size_t next = matched_.size();
    const std::vector<AtomId>* atoms = nullptr;
    for (std::size_t i = 0; i < matched_.size(); ++i) {
      if (matched_[i]) continue;
      const auto& candidates = index_.candidates(schema_->precondition[i].atom, binding_);
      if (atoms == nullptr || candidates.size() < atoms->size()) {
        next = i;
        atoms = &candidates;
      }
    }
    if (atoms == nullptr) {
      bindRest(0);
      return;
    }
    matched_[next] = true;
    for (const AtomId id : *atoms) {
      // Preconditions before the trigger take older atoms only, so that an instantiation that uses
      // the newest atom twice is found once.
      if (id == newest_ && next < triggered_by_) continue;
      checkLimits();
      const std::size_t mark = trail_.size();
      if (match(schema_->precondition[next].atom, result_.atoms[id])) extend();
      undo(mark);
    }
    matched_[next] = false;
  }

  /// Parameters that no positive precondition mentions range over their type.
  void bindRest(std::size_t from) {
    while (from < binding_.size() && binding_[from] != kUnbound)
      ++from;
    if (from == binding_.size()) {
      instantiate();
      return;
    }
    for (const ObjectId object :
         objects_of_[static_cast<std::size_t>(schema_->parameters[from].type)]) {
      checkLimits();
      const std::size_t mark = trail_.size();
      if (bindParameter(from, object)) bindRest(from + 1);
      undo(mark);
    }
  }

  void instantiate() {
    for (const pddl::Equality& equality : schema_->equalities) {
      if ((value(equality.left) == value(equality.right)) == equality.negated) return;
    }
    for (const pddl::LiftedLiteral& literal : schema_->precondition) {
      if (!literal.negated || deletable_[static_cast<std::size_t>(literal.atom.predicate)])
        continue;
      const auto found = result_.ids.find(groundAtom(literal.atom, binding_));
      if (found != result_.ids.end() && found->second < result_.initial_count) return;
    }
    result_.instantiations.push_back({schema_id_, binding_});
    for (const LiftedAtom& atom : schema_->add)
      intern(groundAtom(atom, binding_));
  }

  const Model& model_;
  Limits limits_;
  LimitMonitor monitor_;
  AtomIndex index_;
  std::vector<std::vector<ObjectId>> objects_of_;
  std::vector<std::vector<Occurrence>> occurrences_;
  std::vector<bool> deletable_;
  RelaxedReachability result_;

  // The instantiation under construction.
  AtomId newest_ = 0;
  SchemaId schema_id_ = 0;
  const Schema* schema_ = nullptr;
  std::size_t triggered_by_ = 0;
  std::vector<ObjectId> binding_;
  std::vector<std::size_t> trail_;
  std::vector<bool> matched_;
};

}  // namespace

Atom groundAtom(const LiftedAtom& atom, const std::vector<ObjectId>& arguments) {
  Atom ground;
  ground.predicate = atom.predicate;
  ground.objects.reserve(atom.terms.size());
  for (const Term& term : atom.terms) {
    ground.objects.push_back(term.is_parameter ? arguments[static_cast<std::size_t>(term.index)]
                                               : term.index);
  }
  return ground;
}

RelaxedReachability relaxedReachability(const Model& model, const Limits& limits) {
  return Join(model, limits).run();
}

}  // namespace goal_alignment::grounding
