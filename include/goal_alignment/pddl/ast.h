// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/pddl/source_position.h"

/// What the parser read, as it was written: nothing is looked up or checked against anything yet.
namespace goal_alignment::pddl::ast {

/// A name as its writer spelled it, and where.
struct Name {
  std::string spelling;
  SourcePosition position;
};

/// One entry of a typed list; no type means `object`. For parameters the name has its `?`.
struct TypedName {
  Name name;
  std::shared_ptr<const Name> type;  ///< one for all names of `a b c - type`
};

/// `(predicate term …)`; a term is a parameter when it begins with `?`.
struct Atom {
  Name predicate;
  std::vector<Name> terms;
};

/// An atom or `(= a b)`, possibly under one `not`.
struct Literal {
  Atom atom;
  bool negated = false;
  bool equality = false;  ///< atom.predicate is `=` and there are two terms
};

/// A conjunction; empty is true.
using Condition = std::vector<Literal>;

/// `(increase (total-cost) n)` or `(increase (total-cost) (f term …))`.
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
  std::optional<CostEffect> cost;
};

struct Domain {
  Source source;  ///< name only is used after parsing
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
  Source source;  ///< name only is used after parsing
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
