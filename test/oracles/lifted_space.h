// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"

/// Planning on the lifted model by enumeration: no grounder, no search of the package takes part.
namespace goal_alignment::oracles {

/// The atoms that are true.
using Atoms = std::set<GroundName>;

/// A formula whose quantifiers are spelled out. All without parts is true, Any without is false.
struct GroundFormula {
  enum class Kind { All, Any, Literal };
  Kind kind = Kind::All;
  Literal literal;
  std::vector<GroundFormula> parts;
};

struct GroundEffect {
  GroundFormula condition;
  Atoms add;
  Atoms del;
};

struct GroundAction {
  GroundName name;
  std::vector<Literal> precondition;
  GroundFormula condition;  ///< the rest of it
  Atoms add;
  Atoms del;
  std::vector<GroundEffect> conditional;
  std::int64_t cost = 1;  ///< by the model's metric
};

Atoms initialAtoms(const pddl::Model& model);

/// One action for every tuple of objects that types and equalities allow.
std::vector<GroundAction> allActions(const pddl::Model& model);

/// What the goal asks besides its literals.
GroundFormula goalCondition(const pddl::Model& model);

bool holds(const std::vector<Literal>& literals, const Atoms& atoms);
bool holds(const GroundFormula& formula, const Atoms& atoms);
bool applicable(const GroundAction& action, const Atoms& atoms);
Atoms successor(const GroundAction& action, const Atoms& atoms);

/// The actions that can be reached when nothing is deleted, with the atoms that then appear. A
/// negated precondition may hold where its atom is not true at first, or its predicate is ever
/// deleted. For models of literals alone.
struct RelaxedGrounding {
  Atoms atoms;
  std::vector<GroundAction> actions;
};
RelaxedGrounding groundNaively(const pddl::Model& model);

/// Every reachable state of a small model, as bits for speed alone.
class LiftedSpace {
 public:
  /// Gives up beyond so many states: then complete() is false and nothing else may be asked.
  LiftedSpace(const pddl::Model& model, std::size_t most_states, bool unit_costs = true);

  bool complete() const { return complete_; }
  std::size_t size() const { return cost_.size(); }
  std::vector<Atoms> states() const;

  /// The cheapest way to a state in which all of it holds; nothing: there is none. Atoms that the
  /// model does not know are false.
  std::optional<std::int64_t> cheapest(const std::vector<Literal>& goal) const;

  /// For each state that satisfies `goal`: which of the fluents are true in it. Without duplicates.
  std::set<std::uint64_t> fluentsWith(const std::vector<Literal>& goal,
                                      const std::vector<Literal>& fluents) const;

 private:
  using CandidateMask = std::uint64_t;
  struct BitFormula {
    GroundFormula::Kind kind = GroundFormula::Kind::All;
    CandidateMask bit = 0;
    bool negated = false;
    std::vector<BitFormula> parts;
  };
  struct BitEffect {
    BitFormula condition;
    CandidateMask add = 0;
    CandidateMask del = 0;
  };
  struct BitAction {
    CandidateMask positive = 0;
    CandidateMask negative = 0;
    BitFormula condition;
    CandidateMask add = 0;
    CandidateMask del = 0;
    std::vector<BitEffect> conditional;
    std::int64_t cost = 1;
  };

  static bool holds(const BitFormula& formula, CandidateMask state);
  static bool applicable(const BitAction& action, CandidateMask state);
  static CandidateMask successor(const BitAction& action, CandidateMask state);
  CandidateMask bits(const Atoms& atoms);
  BitFormula bitFormula(const GroundFormula& formula);
  BitAction bitAction(const GroundAction& action, bool unit_costs);
  CandidateMask bit(const GroundName& atom);
  bool holds(const Literal& literal, CandidateMask state) const;
  bool holds(const std::vector<Literal>& goal, CandidateMask state) const;

  std::map<GroundName, std::size_t> index_;
  std::vector<BitAction> actions_;
  std::map<CandidateMask, std::int64_t> cost_;  // by state
  bool complete_ = true;
};

}  // namespace goal_alignment::oracles
