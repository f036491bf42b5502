// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/pddl/near_name.h"
#include "link_context.h"
#include "token_reader.h"

namespace goal_alignment::pddl {

namespace {

/// Bounds what Model::isSubtype() costs, which every fact and every effect asks.
constexpr std::size_t kMaxAbove = 100;

/// Types stand below `object`; lists may name a parent before, after or without declaring it, and
/// one type below several parents.
class TypeLinker {
 public:
  explicit TypeLinker(LinkContext& context) : context_(context), types_(context.model.types) {}

  void link() {
    add({"object", {}});
    for (const ast::TypedName& declared : context_.domain.types)
      add(declared.name);
    for (const ast::TypedName& declared : context_.domain.types)
      addParent(declared);
    setAllAbove();
  }

 private:
  /// The id of the type, new or known.
  TypeId add(const ast::Name& name) {
    const auto id = static_cast<TypeId>(types_.size());
    if (!context_.types.add(name.spelling, id)) return *context_.types.find(name.spelling);
    types_.push_back({Spelled(name.spelling), {}, {}});
    positions_.push_back(name.position);
    parents_.emplace_back();
    return id;
  }

  /// A parent that is declared nowhere else is a type as well: IPC files rely on it.
  void addParent(const ast::TypedName& declared) {
    if (!declared.type) return;
    const TypeId child = add(declared.name);
    const TypeId parent = add(*declared.type);
    // Every type is an object and itself, so saying so changes nothing. The latter happens where a
    // line without a type stands before one that names it as a parent: the `-` counts for both.
    if (parent == kObjectType || parent == child) return;
    if (child == kObjectType) {
      fail(declared.name.position, "'object' is above all types and has no parent");
    }
    std::vector<TypeId>& parents = parents_[child];
    if (std::find(parents.begin(), parents.end(), parent) != parents.end()) return;
    parents.push_back(parent);
    if (parents.size() > kMaxAbove) failAbove(child);
  }

  /// Each type once all its parents are done, in O(types · kMaxAbove · their parents).
  void setAllAbove() {
    std::vector<std::vector<TypeId>> children(types_.size());
    std::vector<std::size_t> waits_for(types_.size());
    std::vector<TypeId> ready;
    for (TypeId type = 0; type < static_cast<TypeId>(types_.size()); ++type) {
      for (const TypeId parent : parents_[type])
        children[parent].push_back(type);
      waits_for[type] = parents_[type].size();
      if (waits_for[type] == 0) ready.push_back(type);
    }
    for (std::size_t next = 0; next < ready.size(); ++next) {
      const TypeId type = ready[next];
      setAbove(type);
      for (const TypeId child : children[type])
        if (--waits_for[child] == 0) ready.push_back(child);
    }
    if (ready.size() < types_.size()) failCycle(waits_for);
  }

  void setAbove(TypeId type) {
    std::vector<TypeId>& above = types_[type].above;
    above.push_back(type);
    for (const TypeId parent : parents_[type]) {
      const std::vector<TypeId>& more = types_[parent].above;
      above.insert(above.end(), more.begin(), more.end());
    }
    std::sort(above.begin(), above.end());
    above.erase(std::unique(above.begin(), above.end()), above.end());
    if (above.size() > kMaxAbove) failAbove(type);
  }

  /// Of the types that wait for a parent, each has one that waits as well.
  [[noreturn]] void failCycle(const std::vector<std::size_t>& waits_for) const {
    const auto waits = [&](TypeId type) { return waits_for[type] > 0; };
    const auto up = [&](TypeId type) {
      return *std::find_if(parents_[type].begin(), parents_[type].end(), waits);
    };
    TypeId type = 0;
    while (!waits(type))
      ++type;
    for (std::vector<bool> seen(types_.size()); !seen[type]; type = up(type))
      seen[type] = true;
    constexpr int kMaxNamed = 5;
    std::string chain;
    TypeId at = type;
    for (int named = 0; named < kMaxNamed && (named == 0 || at != type); ++named, at = up(at)) {
      chain += (named == 0 ? "" : ", ") + spelled(at) + " at " + toString(positions_[at]) +
               " stands below " + spelled(up(at));
    }
    fail(positions_[type], "type " + spelled(type) + " is its own ancestor: " + chain +
                               (at == type ? "" : ", …") +
                               " (a '-' counts for all names before it that have no type yet)");
  }

  [[noreturn]] void failAbove(TypeId type) const {
    fail(positions_[type], "types are nested deeper than " + std::to_string(kMaxAbove));
  }

  [[noreturn]] void fail(SourcePosition at, const std::string& message) const {
    throw SemanticError(context_.domain.source->name, at, message);
  }

  std::string spelled(TypeId type) const { return inQuotes(types_[type].name.spelling); }

  LinkContext& context_;
  std::vector<Type>& types_;
  std::vector<SourcePosition> positions_;     // of each type's first mention
  std::vector<std::vector<TypeId>> parents_;  // but for `object`
};

}  // namespace

TypeId unionOf(LinkContext& context, const ast::TypeName& written, const std::string& source_name) {
  Model& model = context.model;
  std::vector<TypeId> members;
  for (const ast::Name& name : written.either) {
    const TypeId type = context.typeNamed(name, source_name);
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
  model.types.push_back({Spelled(name), {}, std::move(members)});
  return id;
}

void linkTypes(LinkContext& context) {
  TypeLinker(context).link();
}

}  // namespace goal_alignment::pddl
