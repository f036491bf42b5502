// SPDX-License-Identifier: BSD-3-Clause
#include "name_table.h"

#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/near_name.h"

namespace goal_alignment::pddl {

std::string unknownName(const std::string& kind, const std::string& spelling,
                        const std::unordered_map<std::string, int>& known) {
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const auto& [name, id] : known)
    names.push_back(name);
  return "unknown " + kind + " " + inQuotes(spelling) + suggestion(spelling, names);
}

bool NameTable::add(const std::string& spelling, int id) {
  return ids_.emplace(toLower(spelling), id).second;
}

std::optional<int> NameTable::find(const std::string& spelling) const {
  const auto found = ids_.find(toLower(spelling));
  if (found == ids_.end()) return std::nullopt;
  return found->second;
}

int NameTable::at(const ast::Name& name, const std::string& source_name) const {
  if (const std::optional<int> id = find(name.spelling)) return *id;
  throw SemanticError(source_name, name.position, unknownName(kind_, name.spelling, ids_));
}

}  // namespace goal_alignment::pddl
