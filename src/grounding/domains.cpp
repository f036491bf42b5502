// SPDX-License-Identifier: BSD-3-Clause
#include "domains.h"

#include <algorithm>

#include "goal_alignment/common/exceptions.h"

namespace goal_alignment::grounding {

void Domains::pollLimits() {
  pollOrThrow(monitor_, "grounding");
}

const std::shared_ptr<const Domain>& Domains::ofType(pddl::TypeId type) {
  std::shared_ptr<const Domain>& known = of_type_[type];
  if (known) return known;
  Domain objects(model_.objects.size());
  for (std::size_t o = 0; o < objects.size(); ++o) {
    pollLimits();
    objects[o] = model_.isSubtype(model_.objects[o].type, type);
  }
  return known = std::make_shared<const Domain>(std::move(objects));
}

bool Domains::matches(const pddl::LiftedAtom& lifted, const pddl::AtomView& atom) const {
  for (std::size_t i = 0; i < lifted.terms.size(); ++i) {
    const pddl::Term& term = lifted.terms[i];
    const auto object = static_cast<std::size_t>(atom.objects[i]);
    const bool fits =
        term.is_parameter ? (*domains_.at(term.index))[object] : term.index == atom.objects[i];
    if (!fits) return false;
  }
  return true;
}

/// Takes out the objects that no atom supports; whether there were any.
bool Domains::narrow(const pddl::LiftedAtom& lifted) {
  std::unordered_map<int, Domain> supported;
  for (const pddl::Term& term : lifted.terms) {
    if (term.is_parameter) supported.emplace(term.index, Domain(model_.objects.size(), false));
  }
  for (const AtomId id : index_.all(lifted.predicate)) {
    pollLimits();
    const pddl::AtomView atom = atoms_[id];
    if (!matches(lifted, atom)) continue;
    for (std::size_t i = 0; i < lifted.terms.size(); ++i) {
      const pddl::Term& term = lifted.terms[i];
      if (term.is_parameter) {
        supported.at(term.index)[static_cast<std::size_t>(atom.objects[i])] = true;
      }
    }
  }
  bool narrowed = false;
  for (auto& [variable, objects] : supported) {
    std::shared_ptr<const Domain>& domain = domains_.at(variable);
    if (objects == *domain) continue;
    domain = std::make_shared<const Domain>(std::move(objects));
    narrowed = true;
  }
  return narrowed;
}

std::vector<std::shared_ptr<const Domain>> Domains::of(const Rule& rule) {
  const pddl::Schema& schema = model_.schemas[static_cast<std::size_t>(rule.schema)];
  domains_.clear();
  for (const int variable : rule.variables)
    domains_[variable] = ofType(variableOf(schema, variable).type);
  std::vector<const pddl::LiftedAtom*> statics;
  for (const pddl::LiftedAtom& atom : rule.body) {
    const auto p = static_cast<std::size_t>(atom.predicate);
    if (p < model_.predicates.size() && !model_.predicates[p].fluent) statics.push_back(&atom);
  }
  // Stopping early is sound. Trees need few passes; on long cycles the last objects fall one by
  // one.
  bool narrowed = true;
  for (std::size_t pass = 0; narrowed && pass < 2 * statics.size() + 2; ++pass) {
    narrowed = false;
    for (const pddl::LiftedAtom* atom : statics)
      narrowed = narrow(*atom) || narrowed;
  }
  std::vector<std::shared_ptr<const Domain>> result;
  for (const int variable : rule.variables) {
    const std::shared_ptr<const Domain>& domain = domains_.at(variable);
    if (std::find(domain->begin(), domain->end(), true) == domain->end()) return {};
    result.push_back(domain);
  }
  return result;
}

}  // namespace goal_alignment::grounding
