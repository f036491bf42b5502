// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/limits.h"
#include "goal_alignment/pddl/model.h"

/// Executes plans on the lifted model, with the semantics of the IPC's validator (Howey, Long &
/// Fox, ICTAI 2004): knows nothing of grounding, so that a grounding fault can't validate itself.
namespace goal_alignment::validation {

/// The atoms that are true; everything else is false.
using AtomSet = std::unordered_set<pddl::Atom, pddl::AtomHash>;

/// Why a step can't be executed.
struct Violation {
  enum class Kind { UnknownAction, WrongArity, UnknownObject, WrongType, Precondition };
  Kind kind = Kind::UnknownAction;
  std::size_t step = 0;            ///< index in the plan
  std::optional<Literal> literal;  ///< for Kind::Precondition: the literal that is false, if one is
  std::string message;             ///< one sentence naming step, action and what is wrong
  std::vector<Literal> missing;    ///< for Kind::Precondition: ground literals that are all false
                                   ///< and one of which would have to be true; empty: none has
  std::string object;              ///< for Kind::UnknownObject and WrongType: as the plan calls it
};

/// What came of executing a plan, up to the first step that can't be executed. Holds one state and
/// what each step changed: O(state + plan · effects).
class Execution {
 public:
  std::optional<Violation> violation;  ///< nothing: every step was executed
  std::vector<std::int64_t> costs;     ///< costs[i]: of the first i steps, by the model's costs

  std::size_t stepsRun() const { return changes_.size(); }
  const AtomSet& finalState() const { return final_; }
  std::int64_t cost() const { return costs.back(); }

  /// The states in order: the initial one as visit(0, state), then those after each step.
  /// O(state + plan · effects) and what visit takes.
  void forEachState(const std::function<void(std::size_t, const AtomSet&)>& visit) const;

 private:
  friend Execution execute(const pddl::Model& model, const std::vector<GroundName>& plan,
                           const Limits& limits);

  /// What a step really changed.
  struct Change {
    std::vector<pddl::Atom> added;
    std::vector<pddl::Atom> removed;
  };

  AtomSet final_;
  std::vector<Change> changes_;
};

/// Executes from the model's initial state. Throws LimitReached.
/// O(state + plan · (objects to the power of nested quantified variables)).
Execution execute(const pddl::Model& model, const std::vector<GroundName>& plan,
                  const Limits& limits = {});

/// The goal literals that are false in the state, in the order given.
/// A literal that the model can't name is false, its negation true. Throws LimitReached.
std::vector<Literal> unsatisfied(const pddl::Model& model, const AtomSet& state,
                                 const std::vector<Literal>& goal, const Limits& limits = {});

/// Whether the state satisfies what the model's goal asks besides its literals. Throws
/// LimitReached.
bool satisfiesCondition(const pddl::Model& model, const AtomSet& state, const Limits& limits = {});

/// What is wrong with the plan for this goal and the condition of the model's goal, in one
/// sentence, or nothing: it is valid. Throws LimitReached.
std::optional<std::string> fault(const pddl::Model& model, const std::vector<GroundName>& plan,
                                 const std::vector<Literal>& goal, const Limits& limits = {});

}  // namespace goal_alignment::validation
