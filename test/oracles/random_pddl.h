// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/common/random_source.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::oracles {

/// A small lifted model before it becomes PDDL text; literals are text already.
struct ModelSketch {
  struct Typed {
    std::string name;
    std::string type;
  };
  struct Predicate {
    std::string name;
    std::vector<std::string> types;
  };
  struct Action {
    std::string name;
    std::vector<Typed> parameters;
    std::vector<std::string> precondition;
    std::vector<std::string> add;
    std::vector<std::string> del;               ///< the atoms, without `not`
    std::string cost;                           ///< `3` or `(weight ?x)`; empty: none is given
    std::vector<std::string> conditional = {};  ///< effects with `forall` and `when`
  };

  bool typed = true;
  bool metric = false;
  std::vector<Typed> types;  ///< with their parents
  std::vector<Typed> constants;
  std::vector<Typed> objects;
  std::vector<Predicate> predicates;
  std::vector<Action> actions;
  std::vector<std::string> init;
  std::vector<std::string> init_values;
  std::vector<std::string> goal;

  std::string domainText() const;
  std::string problemText() const;
  pddl::Model model() const;

  /// Whether an object of the type may stand where `wanted` is asked for.
  bool isSubtype(const std::string& type, const std::string& wanted) const;
  /// Constants and objects of the type.
  std::vector<std::string> objectsOf(const std::string& type) const;
  /// Every atom of the predicate that the types allow.
  std::vector<std::string> atomsOf(const Predicate& predicate) const;
};

/// Up to three objects (one may be a constant), predicates of no, one and two places (the first of
/// them is static), two to four actions with positive, negative and equality preconditions. Most
/// state spaces are small; some are not, so bound what you do with them.
ModelSketch randomSketch(RandomSource& random);

/// A hand that carries one thing at a time, one piece of soap, things to use and to wash: the two
/// or three things begin where chance puts them. What can't be had together here can't in pairs and
/// triples, as in the planning competitions' domains; in randomSketch() mostly single fluents
/// can't.
ModelSketch carrySketch(RandomSource& random);

/// randomSketch() with all of ADL: any formula, quantified (variables may hide others) and
/// conditional effects, a goal that is a formula, unions of types.
ModelSketch randomAdlSketch(RandomSource& random);

/// A random sketch of at most so many reachable states.
ModelSketch randomSmallSketch(RandomSource& random, std::size_t most_states);
ModelSketch randomSmallAdlSketch(RandomSource& random, std::size_t most_states);

}  // namespace goal_alignment::oracles
