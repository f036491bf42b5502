// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/model.h"

#include <algorithm>

#include "link_context.h"

namespace goal_alignment::pddl {

std::optional<PredicateId> Model::findPredicate(const std::string& lower_name) const {
  return predicate_ids_.findLower(lower_name);
}

std::optional<ObjectId> Model::findObject(const std::string& lower_name) const {
  return object_ids_.findLower(lower_name);
}

std::optional<SchemaId> Model::findSchema(const std::string& lower_name) const {
  return schema_ids_.findLower(lower_name);
}

bool Model::isSubtype(TypeId type, TypeId of) const {
  const auto below = [&](TypeId member) { return isSubtype(member, of); };
  const auto holds = [&](TypeId member) { return isSubtype(type, member); };
  const std::vector<TypeId>& members = types[type].members;
  if (!members.empty()) return std::all_of(members.begin(), members.end(), below);
  const std::vector<TypeId>& of_members = types[of].members;
  if (!of_members.empty()) return std::any_of(of_members.begin(), of_members.end(), holds);
  const std::vector<TypeId>& above = types[type].above;
  return of == kObjectType || std::binary_search(above.begin(), above.end(), of);
}

bool Model::overlap(TypeId a, TypeId b) const {
  const std::vector<TypeId>& members = types[a].members;
  if (!members.empty()) {
    return std::any_of(members.begin(), members.end(),
                       [&](TypeId member) { return overlap(member, b); });
  }
  if (!types[b].members.empty()) return overlap(b, a);
  if (isSubtype(a, b) || isSubtype(b, a)) return true;
  // Some type has both among its parents' lines.
  return std::any_of(types.begin(), types.end(), [&](const Type& type) {
    const auto is = [&](TypeId of) {
      return std::binary_search(type.above.begin(), type.above.end(), of);
    };
    return is(a) && is(b);
  });
}

std::optional<Atom> Model::resolve(const GroundName& ground, std::string* why_not) const {
  const auto fail = [&](const std::string& reason) -> std::optional<Atom> {
    if (why_not != nullptr) *why_not = reason;
    return std::nullopt;
  };
  // The message's cost (it looks for near names) falls on those who want it only.
  const auto unknown = [&](const std::string& name, const NameTable& known) {
    return fail(why_not == nullptr ? std::string() : known.unknown(name));
  };
  const std::optional<PredicateId> id = findPredicate(ground.name);
  if (!id) return unknown(ground.name, predicate_ids_);
  const Predicate& predicate = predicates[*id];
  if (predicate.parameter_types.size() != ground.arguments.size()) {
    return fail(wrongCount(predicate.name.spelling, predicate.parameter_types.size(),
                           ground.arguments.size()));
  }
  std::optional<Atom> atom(std::in_place);
  atom->predicate = *id;
  for (std::size_t i = 0; i < ground.arguments.size(); ++i) {
    const std::optional<ObjectId> object = findObject(ground.arguments[i]);
    if (!object) return unknown(ground.arguments[i], object_ids_);
    const TypeId wanted = predicate.parameter_types[i];
    if (!isSubtype(objects[*object].type, wanted)) {
      return fail(wrongType(*this, objects[*object].name.spelling, objects[*object].type,
                            predicate.name.spelling, wanted));
    }
    atom->objects.push_back(*object);
  }
  return atom;
}

GroundName Model::name(const AtomView& atom) const {
  GroundName ground{predicates[atom.predicate].name.name, {}};
  ground.arguments.reserve(atom.objects.size());
  for (const ObjectId object : atom.objects)
    ground.arguments.push_back(objects[object].name.name);
  return ground;
}

std::vector<Literal> Model::goalLiterals() const {
  std::vector<Literal> literals;
  for (const GoalLiteral& literal : goal)
    literals.push_back({name(literal.atom), literal.negated});
  return literals;
}

std::string Model::spelling(const GroundName& ground) const {
  GroundName spelled = ground;
  // An atom or an action: a name alone does not say which, and few domains use one for both.
  if (const auto predicate = findPredicate(ground.name)) {
    spelled.name = predicates[*predicate].name.spelling;
  } else if (const auto schema = findSchema(ground.name)) {
    spelled.name = schemas[*schema].name.spelling;
  }
  for (std::string& argument : spelled.arguments) {
    if (const auto object = findObject(argument)) argument = objects[*object].name.spelling;
  }
  return spelled.text();
}

void Model::setGoal(const std::vector<Literal>& literals) {
  // Resolved apart first: a literal that does not fit leaves the old goal as it was.
  std::vector<GoalLiteral> linked;
  for (const Literal& literal : literals) {
    std::string why_not;
    const std::optional<Atom> atom = resolve(literal.atom, &why_not);
    if (!atom) {
      throw SemanticError(problem_source, {}, "the goal " + literal.text() + ": " + why_not);
    }
    linked.push_back({*atom, literal.negated});
  }
  goal = std::move(linked);
  goal_condition = {};
  goal_variables.clear();
}

}  // namespace goal_alignment::pddl
