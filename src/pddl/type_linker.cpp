// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>
#include <vector>

#include "goal_alignment/pddl/near_name.h"
#include "link_context.h"

namespace goal_alignment::pddl {

namespace {

constexpr int kDeepestHierarchy = 100;

/// Types form a tree below `object`; lists may name a parent before, after or without declaring it.
class TypeLinker {
 public:
  explicit TypeLinker(LinkContext& context) : context_(context), types_(context.model.types) {}

  void link() {
    add({"object", {}});
    for (const ast::TypedName& declared : context_.domain.types)
      add(declared.name);
    for (const ast::TypedName& declared : context_.domain.types)
      setParent(declared);
    refuseCycles();
    refuseDeepHierarchy();
  }

 private:
  /// The id of the type, new or known.
  TypeId add(const ast::Name& name) {
    const auto id = static_cast<TypeId>(types_.size());
    if (!context_.types.add(name.spelling, id)) return *context_.types.find(name.spelling);
    types_.push_back({Spelled(name.spelling), id == kObjectType ? -1 : kObjectType, {}});
    positions_.push_back(name.position);
    return id;
  }

  /// A parent that is declared nowhere else is a type as well: IPC files rely on it.
  void setParent(const ast::TypedName& declared) {
    if (!declared.type) return;
    const TypeId child = add(declared.name);
    const TypeId parent = add(*declared.type);
    // Every type is an object, so saying so beside another parent changes nothing.
    if (parent == kObjectType) return;
    if (child == kObjectType) fail(declared.name, "'object' is above all types and has no parent");
    if (types_[child].parent != kObjectType && types_[child].parent != parent) {
      fail(declared.name, "type " + inQuotes(declared.name.spelling) + " has two parents, " +
                              inQuotes(types_[types_[child].parent].name.spelling) + " and " +
                              inQuotes(types_[parent].name.spelling));
    }
    types_[child].parent = parent;
  }

  /// Walks up from every type, but over each only once.
  void refuseCycles() const {
    std::vector<TypeId> walk_of(types_.size(), -1);
    walk_of[kObjectType] = kObjectType;
    for (TypeId start = 0; start < static_cast<TypeId>(types_.size()); ++start) {
      TypeId type = start;
      while (walk_of[type] == -1) {
        walk_of[type] = start;
        type = types_[type].parent;
      }
      if (walk_of[type] == start && type != kObjectType) {
        throw SemanticError(
            context_.domain.source->name, positions_[type],
            "type " + inQuotes(types_[type].name.spelling) + " is its own ancestor");
      }
    }
  }

  /// Bounds what Model::isSubtype() costs, which every fact and every effect asks.
  void refuseDeepHierarchy() const {
    for (std::size_t start = 0; start < types_.size(); ++start) {
      int depth = 0;
      for (auto type = static_cast<TypeId>(start); type != kObjectType; type = types_[type].parent)
        if (++depth > kDeepestHierarchy) {
          throw SemanticError(context_.domain.source->name, positions_[start],
                              "types are nested deeper than " + std::to_string(kDeepestHierarchy));
        }
    }
  }

  [[noreturn]] void fail(const ast::Name& at, const std::string& message) const {
    throw SemanticError(context_.domain.source->name, at.position, message);
  }

  LinkContext& context_;
  std::vector<Type>& types_;
  std::vector<SourcePosition> positions_;  ///< of each type's first mention
};

}  // namespace

TypeId unionOf(LinkContext& context, const ast::TypeName& written, const std::string& source_name) {
  Model& model = context.model;
  std::vector<TypeId> members;
  for (const ast::Name& name : written.either) {
    const TypeId type = context.types.at(name, source_name);
    const auto covers = [&](TypeId member) { return model.isSubtype(type, member); };
    if (std::any_of(members.begin(), members.end(), covers)) continue;
    const auto covered = [&](TypeId member) { return model.isSubtype(member, type); };
    members.erase(std::remove_if(members.begin(), members.end(), covered), members.end());
    members.push_back(type);
  }
  if (members.size() == 1) return members.front();
  std::sort(members.begin(), members.end());
  std::string name = "(either";
  for (const TypeId member : members)
    name += " " + model.types[member].name.name;
  name += ")";
  // No declared type's name has parentheses, so that unions may stand among them.
  const auto id = static_cast<TypeId>(model.types.size());
  if (!context.types.add(name, id)) return *context.types.find(name);
  model.types.push_back({Spelled(name), kObjectType, std::move(members)});
  return id;
}

void linkTypes(LinkContext& context) {
  TypeLinker(context).link();
}

}  // namespace goal_alignment::pddl
