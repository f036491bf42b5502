// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/precondition_monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "goal_alignment/validation/execution.h"

namespace goal_alignment::execution {
namespace {

using validation::Violation;
using Verdict = PreconditionMonitor::Verdict;

bool contains(const std::vector<GroundName>& atoms, const GroundName& atom) {
  return std::find(atoms.begin(), atoms.end(), atom) != atoms.end();
}

// The step is the only one of its plan, so the violation's own number says nothing.
std::string reasonOf(const Violation& violation) {
  const std::size_t colon = violation.message.find("): ");
  return colon == std::string::npos ? violation.message : violation.message.substr(colon + 3);
}

void enter(std::vector<GroundName>& sorted, const GroundName& atom) {
  const auto place = std::lower_bound(sorted.begin(), sorted.end(), atom);
  if (place == sorted.end() || *place != atom) sorted.insert(place, atom);
}

void remove(std::vector<GroundName>& atoms, const GroundName& atom) {
  atoms.erase(std::remove(atoms.begin(), atoms.end(), atom), atoms.end());
}

}  // namespace

void WorldState::apply(const std::vector<Literal>& changes) {
  for (const Literal& change : changes) {
    remove(unknown, change.atom);
    if (change.negated) {
      remove(facts, change.atom);
    } else {
      enter(facts, change.atom);
    }
  }
}

bool PreconditionMonitor::setState(const WorldState& world, bool unknown_hold,
                                   std::string& stranger) {
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

PreconditionMonitor::Finding PreconditionMonitor::precondition(const GroundName& action,
                                                               const WorldState& world) {
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

PreconditionMonitor::Finding PreconditionMonitor::literals(const std::vector<Literal>& wanted,
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

PreconditionMonitor::Finding PreconditionMonitor::rest(const std::vector<GroundName>& steps,
                                                       const std::vector<Literal>& wanted,
                                                       const WorldState& world) {
  const Finding finding = tryRest(steps, wanted, world, false);
  if (finding.verdict != Verdict::False || world.unknown.empty()) return finding;
  const Finding other = tryRest(steps, wanted, world, true);
  return other.verdict == Verdict::Holds ? other : finding;
}

// What the steps need of the unknown atoms becomes so, of each once: if it is needed the other way
// round as well, there is no world in which they succeed.
PreconditionMonitor::Finding PreconditionMonitor::tryRest(const std::vector<GroundName>& steps,
                                                          const std::vector<Literal>& wanted,
                                                          const WorldState& world,
                                                          bool unknown_hold) {
  std::set<GroundName> open(world.unknown.begin(), world.unknown.end());
  WorldState assumed{world.facts, {}};
  if (unknown_hold) assumed.unknown = {open.begin(), open.end()};
  while (true) {
    std::string stranger;
    if (!setState(assumed, true, stranger)) {
      return {Verdict::NoModel,
              fmt::format("the robot's model does not know the fact {}", stranger), 0};
    }
    const validation::Execution execution = validation::execute(model_, steps);
    std::optional<Literal> needed;
    Finding finding;
    if (const auto& violation = execution.violation) {
      const bool is_false = violation->kind == Violation::Kind::Precondition;
      finding = {is_false ? Verdict::False : Verdict::NoModel, reasonOf(*violation),
                 violation->step};
      needed = violation->literal;
    } else {
      const auto missing = validation::unsatisfied(model_, execution.finalState(), wanted);
      if (missing.empty()) return {};
      needed = missing.front();
      finding = {Verdict::False, fmt::format("{} would not hold", needed->text()), steps.size()};
    }
    if (!needed || open.erase(needed->atom) == 0) return finding;
    remove(assumed.unknown, needed->atom);
    if (!needed->negated) assumed.unknown.push_back(needed->atom);
  }
}

std::vector<Literal> PreconditionMonitor::certainEffects(const GroundName& action) const {
  const auto id = model_.findSchema(action.name);
  if (!id) return {};
  const pddl::Schema& schema = model_.schemas[*id];
  if (schema.parameters.size() != action.arguments.size()) return {};
  std::vector<Literal> changes;
  const auto enterAll = [&](const std::vector<pddl::LiftedAtom>& atoms, bool negated) {
    for (const pddl::LiftedAtom& lifted : atoms) {
      GroundName atom{model_.predicates[lifted.predicate].name.name, {}};
      for (const pddl::Term& term : lifted.terms) {
        atom.arguments.push_back(term.is_parameter ? action.arguments[term.index]
                                                   : model_.objects[term.index].name.name);
      }
      const bool is_added = std::count(changes.begin(), changes.end(), Literal{atom, false}) > 0;
      if (!is_added) changes.push_back({std::move(atom), negated});
    }
  };
  enterAll(schema.add, false);
  enterAll(schema.del, true);
  std::sort(changes.begin(), changes.end());
  changes.erase(std::unique(changes.begin(), changes.end()), changes.end());
  return changes;
}

std::vector<Literal> PreconditionMonitor::effects(const GroundName& action,
                                                  const WorldState& world) {
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
