// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <stdexcept>
#include <string>

#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/pddl/perturbation.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/forgettable.h"
#include "promise.h"
#include "targets.h"

namespace goal_alignment::fuzz {

namespace {

// A line of its own, short enough to be hit upon and no PDDL.
constexpr std::string_view kSeparator = "\n===\n";

/// Every atom that a model holds has a name, and the name leads back to it.
void checkNames(const pddl::Model& model) {
  for (const pddl::Atom& atom : model.init) {
    const GroundName name = model.name(atom);
    const auto resolved = model.resolve(name);
    promise(resolved && *resolved == atom, "the name resolves: " + name.text());
    promise(toLower(model.spelling(name)) == name.text(), "spelling changes case only");
  }
  pddl::Model copy = model;
  copy.setGoal(model.goalLiterals());
  promise(copy.goal.size() == model.goal.size(), "a model takes its own goal");
}

/// A small text may name more ground actions than there are atoms in the world, so a short deadline
/// is part of this.
void groundShortly(const pddl::Model& model) {
  constexpr double kSeconds = 0.02;
  Limits limits = Limits{}.withSeconds(kSeconds);
  limits.bytes = std::size_t{32} << 20U;
  try {
    const auto goal = model.goalLiterals();
    const grounding::GroundTask ground = grounding::ground(model, goal, {}, limits);
    for (const Literal& literal : goal) {
      promise(ground.status(literal).kind != grounding::FactStatus::Kind::Unknown,
              "grounding knows the goal's literals");
    }
    const bool possible = !ground.goal(goal).alternatives.empty();
    const validation::Execution nothing_done = validation::execute(model, {}, limits);
    const bool at_once = validation::unsatisfied(model, nothing_done.finalState(), goal).empty() &&
                         validation::satisfiesCondition(model, nothing_done.finalState(), limits);
    promise(possible || !at_once, "a goal that holds at first is possible");
  } catch (const LimitReached&) {
  } catch (const pddl::InputError&) {
    // A cost without a value or too many alternatives show only now, and stand nowhere in
    // particular.
  }
}

/// A person may know nothing of what an action needs or ends, and the rest is still a domain; but
/// for preconditions without which an effect could be of the wrong type.
void forgetEverything(const pddl::Source& domain) {
  const auto all = oracles::forgettableOf(pddl::parseDomain(domain));
  RandomSource random(domain.text.size());
  try {
    const auto human = pddl::perturb(domain, all.preconditions, all.deletes, random);
    const auto domain_left = pddl::parseDomain({"human.pddl", human.text});
    const auto left = oracles::forgettableOf(domain_left);
    promise(left.preconditions == 0 && left.deletes == 0, "all of it is forgotten");
    pddl::checkDomain(domain_left);
  } catch (const std::invalid_argument& refused) {
    promiseMessage(refused.what());
    promise(all.preconditions > 0, "what an action ends can be forgotten");
  }
}

}  // namespace

void pddl(std::string_view bytes) {
  const std::size_t at = bytes.find(kSeparator);
  const bool two = at != std::string_view::npos;
  const pddl::Source domain{"d.pddl", std::string(bytes.substr(0, at))};
  const pddl::Source problem{"p.pddl",
                             std::string(two ? bytes.substr(at + kSeparator.size()) : bytes)};

  if (isRead([&] { pddl::checkDomain(pddl::parseDomain(domain)); })) forgetEverything(domain);
  const auto faults = pddl::faults(domain, problem);
  std::optional<pddl::Model> model;
  const bool read = isRead([&] { model = pddl::readModel(domain, problem); });
  promise(read == faults.empty(), "faults() and readModel() agree");
  if (!model) return;
  checkNames(*model);
  groundShortly(*model);
}

}  // namespace goal_alignment::fuzz
