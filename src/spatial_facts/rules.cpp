// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/spatial_facts/rules.h"

#include <algorithm>

namespace goal_alignment::spatial_facts {

bool Rule::owns(const GroundName& atom) const {
  if (atom.name != pattern.name || atom.arguments.size() != owned.size()) return false;
  for (std::size_t i = 0; i < owned.size(); ++i) {
    const auto& objects = owned[i];
    if (objects.empty()) continue;
    if (std::find(objects.begin(), objects.end(), atom.arguments[i]) == objects.end()) return false;
  }
  return true;
}

GroundName Rule::key(GroundName atom) const {
  if (exactly_one) atom.arguments[slot] = "?";
  return atom;
}

void Rules::check(const pddl::Model& model) const {
  const auto demand = [&](const Rule& rule, const GroundName& atom) {
    std::string why_not;
    if (model.resolve(atom, &why_not)) return;
    throw RulesError(rule.place + ": the robot's model can't have " + atom.text() + ": " + why_not);
  };
  for (const Rule& rule : rules_) {
    for (const Group& group : rule.groups) {
      for (const Group::Option& option : group.options)
        demand(rule, option.atom);
      if (rule.otherwise != Otherwise::Object) continue;
      GroundName other = group.options.front().atom;
      other.arguments[rule.slot] = rule.otherwise_object;
      demand(rule, other);
    }
  }
}

const Rule* Rules::ownerOf(const GroundName& atom) const {
  const auto owner =
      std::find_if(rules_.begin(), rules_.end(), [&](const Rule& rule) { return rule.owns(atom); });
  return owner == rules_.end() ? nullptr : &*owner;
}

}  // namespace goal_alignment::spatial_facts
