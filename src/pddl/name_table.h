// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "goal_alignment/pddl/ast.h"

namespace goal_alignment::pddl {

/// `unknown object 'b'; did you mean 'b1'?`
std::string unknownName(const std::string& kind, const std::string& spelling,
                        const std::unordered_map<std::string, int>& known);

/// The ids of one kind of names (types, objects, …), by lower case.
class NameTable {
 public:
  /// `kind` in the singular, for messages.
  explicit NameTable(std::string kind) : kind_(std::move(kind)) {}

  const std::string& kind() const { return kind_; }
  /// False where the name is there already.
  bool add(const std::string& spelling, int id);
  std::optional<int> find(const std::string& spelling) const;
  /// Throws SemanticError for a name that was never declared.
  int at(const ast::Name& name, const std::string& source_name) const;

  std::unordered_map<std::string, int> release() { return std::move(ids_); }

 private:
  std::string kind_;
  std::unordered_map<std::string, int> ids_;
};

}  // namespace goal_alignment::pddl
