// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/robot_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "goal_alignment/validation/execution.h"

namespace goal_alignment::execution {
namespace {

using validation::Violation;
using Verdict = RobotWatch::Verdict;

bool contains(const std::vector<GroundName>& atoms, const GroundName& atom) {
  return std::find(atoms.begin(), atoms.end(), atom) != atoms.end();
}

// The step is the only one of its plan, so the violation's own number says nothing.
std::string reasonOf(const Violation& violation) {
  const std::size_t colon = violation.message.find("): ");
  return colon == std::string::npos ? violation.message : violation.message.substr(colon + 3);
}

}  // namespace

bool RobotWatch::setState(const WorldState& world, bool unknown_hold, std::string& stranger) {
  model_.init.clear();
  for (const auto* atoms : {&world.facts, unknown_hold ? &world.unknown : nullptr}) {
    if (atoms == nullptr) continue;
    for (const GroundName& name : *atoms) {
      const auto atom = model_.resolve(name);
      if (!atom) {
        stranger = name.text();
        return false;
      }
      model_.init.push_back(*atom);
    }
  }
  return true;
}

RobotWatch::Finding RobotWatch::precondition(const GroundName& action, const WorldState& world) {
  std::optional<Violation> violations[2];
  for (const bool unknown_hold : {false, true}) {
    std::string stranger;
    if (!setState(world, unknown_hold, stranger)) {
      return {Verdict::NoModel,
              fmt::format("the robot's model does not know the fact {}", stranger)};
    }
    violations[unknown_hold ? 1 : 0] = validation::execute(model_, {action}).violation;
  }
  const auto& [without, with] = violations;
  if (!without && !with) return {};
  const Violation& violation = without ? *without : *with;
  if (violation.kind != Violation::Kind::Precondition)
    return {Verdict::NoModel, reasonOf(violation)};
  const bool is_open = violation.literal ? contains(world.unknown, violation.literal->atom)
                                         : without.has_value() != with.has_value();
  if (!is_open) return {Verdict::False, reasonOf(violation)};
  return {Verdict::Unknown, violation.literal ? fmt::format("nobody knows whether {} holds",
                                                            violation.literal->atom.text())
                                              : reasonOf(violation) + " or not, nobody knows"};
}

RobotWatch::Finding RobotWatch::literals(const std::vector<Literal>& wanted,
                                         const WorldState& world) const {
  Finding finding;
  for (const Literal& literal : wanted) {
    if (contains(world.unknown, literal.atom)) {
      finding = {Verdict::Unknown,
                 fmt::format("nobody knows whether {} holds", literal.atom.text())};
    } else if (contains(world.facts, literal.atom) == literal.negated) {
      return {Verdict::False, fmt::format("{} does not hold", literal.text())};
    }
  }
  return finding;
}

std::vector<Literal> RobotWatch::effects(const GroundName& action, const WorldState& world) {
  std::vector<Literal> changes;
  std::string stranger;
  if (!setState(world, false, stranger)) return changes;
  const validation::Execution execution = validation::execute(model_, {action});
  if (execution.violation) return changes;
  execution.forEachState([&](std::size_t index, const validation::AtomSet& before) {
    if (index != 0) return;
    const validation::AtomSet& after = execution.finalState();
    for (const pddl::Atom& atom : before) {
      if (after.count(atom) == 0) changes.push_back({model_.name(atom), true});
    }
    for (const pddl::Atom& atom : after) {
      if (before.count(atom) == 0) changes.push_back({model_.name(atom), false});
    }
  });
  std::sort(changes.begin(), changes.end());
  return changes;
}

}  // namespace goal_alignment::execution
