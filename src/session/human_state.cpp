// SPDX-License-Identifier: BSD-3-Clause
#include "human_state.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "goal_alignment/validation/execution.h"

namespace goal_alignment::session {
namespace {

using Atoms = std::vector<pddl::Atom>;

bool hasPredicate(const pddl::Model& model, const GroundName& atom) {
  const auto id = model.findPredicate(atom.name);
  if (!id) return false;
  const auto& types = model.predicates[static_cast<std::size_t>(*id)].parameter_types;
  return types.size() == atom.arguments.size();
}

std::vector<HumanFact> possible(const std::vector<HumanFact>& facts, const pddl::Model& robot,
                                const pddl::Model& human) {
  std::vector<HumanFact> result;
  std::copy_if(facts.begin(), facts.end(), std::back_inserter(result), [&](const HumanFact& each) {
    return (!each.of_robot || hasPredicate(robot, each.fact.atom)) &&
           human.resolve(each.fact.atom).has_value();
  });
  return result;
}

// Of one atom the last fact counts.
Atoms changed(Atoms init, const std::vector<HumanFact>& facts, const pddl::Model& human) {
  std::unordered_map<pddl::Atom, bool, pddl::AtomHash> changes;
  Atoms in_order;
  for (const HumanFact& each : facts) {
    const pddl::Atom atom = *human.resolve(each.fact.atom);
    if (changes.insert_or_assign(atom, !each.fact.negated).second) in_order.push_back(atom);
  }
  const auto is_changed = [&](const pddl::Atom& atom) { return changes.count(atom) > 0; };
  init.erase(std::remove_if(init.begin(), init.end(), is_changed), init.end());
  std::copy_if(in_order.begin(), in_order.end(), std::back_inserter(init),
               [&](const pddl::Atom& atom) { return changes.at(atom); });
  return init;
}

// Whether something was left out.
bool leaveOut(const std::string& predicate, std::vector<HumanFact>& facts) {
  const auto rest = std::remove_if(facts.begin(), facts.end(), [&](const HumanFact& each) {
    return each.of_robot && each.fact.atom.name == predicate;
  });
  const bool any = rest != facts.end();
  facts.erase(rest, facts.end());
  return any;
}

}  // namespace

void applyHumanFacts(const std::vector<HumanFact>& facts, const std::vector<GroundName>& human_plan,
                     const pddl::Model& robot, pddl::Model& human, const Limits& limits) {
  if (facts.empty()) return;
  const Atoms init = human.init;
  std::vector<HumanFact> counting = possible(facts, robot, human);
  const Atoms now = changed(init, counting, human);
  human.init = now;
  while (const auto violation = validation::execute(human, human_plan, limits).violation) {
    if (!violation->literal || !leaveOut(violation->literal->atom.name, counting)) {
      human.init = now;  // the plan does not run in any case
      return;
    }
    human.init = changed(init, counting, human);
  }
}

}  // namespace goal_alignment::session
