// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "goal_alignment/common/ground_name.h"
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
  std::optional<Literal> literal;  ///< the precondition that is false, for Kind::Precondition
  std::string message;             ///< one sentence naming step, action and what is wrong
};

/// What came of executing a plan: the states, up to the first step that can't be executed.
struct Execution {
  std::vector<AtomSet> states;         ///< states[i]: before step i; the last one is the end
  std::optional<Violation> violation;  ///< nothing: every step was executed
  std::vector<std::int64_t> costs;  ///< costs[i]: of the steps before state i, by the model's costs

  const AtomSet& finalState() const { return states.back(); }
  std::int64_t cost() const { return costs.back(); }
};

/// Executes from the model's initial state. O(sum of the states' sizes).
Execution execute(const pddl::Model& model, const std::vector<GroundName>& plan);

/// The goal literals that are false in the state, in the order given.
/// A literal that the model can't name is false, its negation true.
std::vector<Literal> unsatisfied(const pddl::Model& model, const AtomSet& state,
                                 const std::vector<Literal>& goal);

/// What is wrong with the plan for this goal, in one sentence, or nothing: it is valid.
std::optional<std::string> fault(const pddl::Model& model, const std::vector<GroundName>& plan,
                                 const std::vector<Literal>& goal);

}  // namespace goal_alignment::validation
