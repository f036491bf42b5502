// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/common/short_vector.h"
#include "goal_alignment/common/span.h"
#include "goal_alignment/pddl/ast.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/name_table.h"

namespace goal_alignment::pddl {

using TypeId = int;
using ObjectId = int;
using PredicateId = int;
using SchemaId = int;

/// The type every object has; `number` is no type of objects.
constexpr TypeId kObjectType = 0;

/// A name in lower case, by which it is matched, and as its writer spelled it, for people.
struct Spelled {
  std::string name;
  std::string spelling;

  Spelled() = default;
  explicit Spelled(std::string_view written) : name(toLower(written)), spelling(written) {}
};

/// A type below `object`, which may have several parents, or the union `(either a b)`, which stands
/// beside those.
struct Type {
  Spelled name;
  std::vector<TypeId> above;    ///< itself and all above it but `object`, sorted; a union: none
  std::vector<TypeId> members;  ///< of a union, none a subtype of another; else empty
};

struct Object {
  Spelled name;
  TypeId type = kObjectType;
};

struct Predicate {
  Spelled name;
  std::vector<TypeId> parameter_types;
  bool fluent = false;  ///< some action adds or deletes it
};

/// A term of a lifted atom: the action's n-th parameter, from there on a quantified variable, or an
/// object.
struct Term {
  bool is_parameter = false;
  int index = 0;  ///< index of the parameter or variable, or ObjectId
};

struct LiftedAtom {
  PredicateId predicate = 0;
  std::vector<Term> terms;
};

struct LiftedLiteral {
  LiftedAtom atom;
  bool negated = false;
};

struct Equality {
  Term left;
  Term right;
  bool negated = false;  ///< true for `(not (= a b))`
};

struct Parameter {
  std::string name;  ///< lower case, without `?`
  TypeId type = kObjectType;
};

/// A formula in negation normal form: negations stand at atoms only, implications are disjunctions.
struct Formula {
  enum class Kind : std::uint8_t { And, Or, ForAll, Exists, Literal, Equality };
  Kind kind = Kind::And;  ///< And without parts is true, Or without parts is false
  LiftedLiteral literal;
  Equality equality;
  std::vector<int> variables;  ///< of a quantifier: as Term::index, each bound by this one alone
  std::vector<Formula> parts;  ///< a quantifier has one

  /// Whether nothing is asked.
  bool trivial() const { return kind == Kind::And && parts.empty(); }
};

/// `(forall (variable …) (when condition (and literal …)))`. The condition counts in the state that
/// the action is applied in.
struct ConditionalEffect {
  std::vector<int> variables;  ///< as Formula::variables
  Formula condition;
  std::vector<LiftedAtom> add;
  std::vector<LiftedAtom> del;
};

/// An action schema. Where its effects both add and delete one ground atom, the add wins.
struct Schema {
  Spelled name;
  std::vector<Parameter> parameters;
  std::vector<Parameter> quantified;  ///< the variables behind the parameters, of all formulas
  std::vector<LiftedLiteral> precondition;  ///< conjuncts that are literals …
  std::vector<Equality> equalities;         ///< … or equalities of the parameters,
  Formula condition;                        ///< and what the precondition asks besides
  std::vector<LiftedAtom> add;
  std::vector<LiftedAtom> del;
  std::vector<ConditionalEffect> conditional;
  std::int64_t constant_cost = 0;          ///< of `(increase (total-cost) n)`, all together
  std::vector<LiftedAtom> function_costs;  ///< of `(increase (total-cost) (f …))`; .predicate
                                           ///< indexes Model::functions
};

/// The arguments of an atom; few have more than four, and these need no memory of their own.
using Objects = ShortVector<ObjectId, 4>;

/// `(predicate object …)` by ids.
struct Atom {
  PredicateId predicate = 0;
  Objects objects;

  friend bool operator==(const Atom& a, const Atom& b) {
    return a.predicate == b.predicate && a.objects == b.objects;
  }
};

/// An atom whose objects stand in somebody else's memory.
struct AtomView {
  PredicateId predicate = 0;
  Span<ObjectId> objects;

  AtomView() = default;
  AtomView(PredicateId of, Span<ObjectId> these) : predicate(of), objects(these) {}
  AtomView(const Atom& atom) : AtomView(atom.predicate, atom.objects) {}  // NOLINT: the same atom

  friend bool operator==(const AtomView& a, const AtomView& b) {
    return a.predicate == b.predicate && a.objects == b.objects;
  }
};

struct AtomHash {
  std::size_t operator()(const AtomView& atom) const noexcept {
    // Ids are small and dense; a multiplication each spreads them over the buckets.
    std::uint64_t hash = static_cast<std::uint64_t>(atom.predicate) + 1;
    for (const ObjectId object : atom.objects) {
      hash = (hash ^ (static_cast<std::uint64_t>(object) + 1)) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
  }
};

struct GoalLiteral {
  Atom atom;
  bool negated = false;
};

/// A domain and a problem, checked against each other and resolved to ids: the lifted model that
/// grounding and validation read. Immutable once linked.
struct Model {
  std::string domain_source;  ///< names of the files, for messages
  std::string problem_source;
  std::vector<Type> types;      ///< [kObjectType] is `object`
  std::vector<Object> objects;  ///< the domain's constants first
  std::vector<Predicate> predicates;
  std::vector<Predicate> functions;  ///< numeric, without total-cost
  std::vector<Schema> schemas;
  std::vector<Atom> init;                 ///< without duplicates
  std::vector<GoalLiteral> goal;          ///< the conjuncts that are literals,
  Formula goal_condition;                 ///< and what the goal asks besides
  std::vector<Parameter> goal_variables;  ///< that the condition quantifies
  std::unordered_map<Atom, std::int64_t, AtomHash> function_values;
  bool has_costs = false;  ///< the problem minimises total-cost; else every action costs 1

  std::optional<PredicateId> findPredicate(const std::string& lower_name) const;
  std::optional<ObjectId> findObject(const std::string& lower_name) const;
  std::optional<SchemaId> findSchema(const std::string& lower_name) const;

  /// Reflexive and transitive. O(log types above · size of the unions), which are bounded.
  bool isSubtype(TypeId type, TypeId of) const;

  /// Whether an object may be of both types. O(types), where neither stands above the other.
  bool overlap(TypeId a, TypeId b) const;

  /// The atom by ids, or nothing where the predicate, an object, the arity or a type does not fit;
  /// `why_not`, if given, then says which.
  std::optional<Atom> resolve(const GroundName& ground, std::string* why_not = nullptr) const;

  GroundName name(const AtomView& atom) const;
  std::vector<Literal> goalLiterals() const;

  /// The text of an atom or action with the names as they were written, where this model knows
  /// them, else as they are.
  std::string spelling(const GroundName& ground) const;

  /// The formula with objects for the variables that are bound (`binding[i]` ≥ 0). Two formulas of
  /// one text mean the same: names are in lower case, quantified variables are called by their
  /// depth, conjuncts and disjuncts are sorted and without duplicates. O(size · depth).
  std::string text(const Formula& formula, const std::vector<Parameter>& variables,
                   const std::vector<ObjectId>& binding = {}) const;
  /// What the goal asks besides its literals, as text(); empty: nothing.
  std::string goalConditionText() const;

  /// The goal becomes these literals. Throws SemanticError naming the literal that does not fit.
  void setGoal(const std::vector<Literal>& literals);

 private:
  friend Model link(const ast::Domain& domain, const ast::Problem& problem, const Limits& limits);
  NameTable predicate_ids_{"predicate"};
  NameTable object_ids_{"object"};
  NameTable schema_ids_{"action"};
};

/// Checks and resolves. Throws SemanticError (undeclared or doubly declared names, wrong arity,
/// wrong types, cyclic types, a problem for another domain, a negative cost, …) at the first fault.
/// What the domain alone has comes first. Polls the limits at every fact and throws LimitReached.
/// O(size of both texts).
Model link(const ast::Domain& domain, const ast::Problem& problem, const Limits& limits = {});

/// Throws what link() would whatever the problem is, so that objects which the domain does not
/// declare are none of its faults.
void checkDomain(const ast::Domain& domain, const Limits& limits = {});

/// parseDomain, parseProblem and link in one. Throws SyntaxError where the two texts have changed
/// places.
Model readModel(const Source& domain, const Source& problem, const Limits& limits = {});

/// Every fault found, as `file:line:column: message`: the syntax of both texts, then (when both
/// parse) the first semantic one. Empty: the pair can be planned with. Never throws.
std::vector<std::string> faults(const Source& domain, const Source& problem);

}  // namespace goal_alignment::pddl
