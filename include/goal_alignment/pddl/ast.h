// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "goal_alignment/common/short_vector.h"
#include "goal_alignment/pddl/source_position.h"

/// What the parser read, as it was written: nothing is looked up or checked against anything yet.
/// Names point into the text, and short lists stand where they are used, so that the ast of many
/// megabytes is soon freed.
namespace goal_alignment::pddl::ast {

/// A name as its writer spelled it, and where.
struct Name {
  std::string_view spelling;  ///< into the source
  SourcePosition position;
};

/// A type, or the union `(either a b)`.
struct TypeName : Name {
  std::vector<Name> either;  ///< the members of a union; empty: the one type of this name
};

/// One entry of a typed list; no type means `object`. For variables the name has its `?`.
struct TypedName {
  Name name;
  std::shared_ptr<const TypeName> type;  ///< one for all names of `a b c - type`
};

using Names = ShortVector<Name, 3>;

/// `(predicate term …)`; a term is a parameter or a quantified variable when it begins with `?`.
struct Atom {
  Name predicate;
  Names terms;
};

/// An atom or `(= a b)`, possibly under one `not`.
struct Literal {
  Atom atom;
  bool negated = false;
  bool equality = false;  ///< atom.predicate is `=` and there are two terms
};

/// What may be true in a state. Nested as deep as the text, which its reader bounds.
struct Formula {
  enum class Kind { Literal, And, Or, Not, Imply, ForAll, Exists };
  Kind kind = Kind::Literal;
  Literal literal;                   ///< of Kind::Literal
  std::vector<TypedName> variables;  ///< of a quantifier
  std::vector<Formula> parts;        ///< one of Not and the quantifiers, two of Imply
};

/// A conjunction, flattened; empty is true.
using Condition = std::vector<Formula>;

/// `(forall (variable …) effect)` or `(when condition effect)`.
struct ConditionalEffect {
  std::vector<TypedName> variables;
  Condition condition;
  std::vector<Literal> literals;
  std::vector<ConditionalEffect> nested;
};

/// `(increase (total-cost) n)` or `(increase (total-cost) (f term …))`; several add up.
struct CostEffect {
  std::int64_t constant = 0;
  std::optional<Atom> function;
};

struct Predicate {
  Name name;
  std::vector<TypedName> parameters;
};

struct Action {
  Name name;
  std::vector<TypedName> parameters;
  Condition precondition;
  std::vector<Literal> effect;
  std::vector<ConditionalEffect> conditional;
  std::vector<CostEffect> costs;
};

struct Domain {
  std::shared_ptr<const Source> source;  ///< what all names point into
  Name name;
  std::vector<Name> requirements;
  std::vector<TypedName> types;
  std::vector<TypedName> constants;
  std::vector<Predicate> predicates;
  std::vector<Predicate> functions;
  std::vector<Action> actions;
};

/// `(= (f obj …) n)` in `:init`.
struct FunctionValue {
  Atom function;
  std::int64_t value = 0;
};

struct Problem {
  std::shared_ptr<const Source> source;  ///< what all names point into
  Name name;
  Name domain_name;
  std::vector<TypedName> objects;
  std::vector<Atom> init;
  std::vector<Atom> init_false;  ///< `(not (p obj …))`: says what the closed world says anyway
  std::vector<FunctionValue> init_values;
  Condition goal;
  SourcePosition goal_position;
  bool minimises_total_cost = false;  ///< `(:metric minimize (total-cost))`
};

}  // namespace goal_alignment::pddl::ast
