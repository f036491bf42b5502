// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/pddl/name_table.h"

#include <functional>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::pddl {

bool NameTable::add(std::string_view spelling, int id) {
  const std::string name = toLower(spelling);
  if (findLower(name)) return false;
  table_.insert(std::hash<std::string_view>{}(name), static_cast<IdTable::Id>(entries_.size()));
  entries_.push_back({text_.size(), name.size(), id});
  text_ += name;
  return true;
}

std::optional<int> NameTable::find(std::string_view spelling) const {
  return findLower(toLower(spelling));
}

std::optional<int> NameTable::findLower(std::string_view name) const {
  const IdTable::Id entry = table_.find(std::hash<std::string_view>{}(name), [&](IdTable::Id id) {
    return nameOf(entries_[id]) == name;
  });
  if (entry == IdTable::kNone) return std::nullopt;
  return entries_[entry].id;
}

int NameTable::at(const ast::Name& name, const std::string& source_name) const {
  if (const std::optional<int> id = find(name.spelling)) return *id;
  throw SemanticError(source_name, name.position, unknown(name.spelling));
}

std::string NameTable::unknown(std::string_view spelling) const {
  std::vector<std::string> names;
  names.reserve(entries_.size());
  for (const Entry& entry : entries_)
    names.emplace_back(nameOf(entry));
  return "unknown " + kind_ + " " + inQuotes(spelling) + suggestion(spelling, names);
}

}  // namespace goal_alignment::pddl
