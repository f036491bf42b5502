// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "goal_alignment/common/id_table.h"
#include "goal_alignment/pddl/ast.h"

namespace goal_alignment::pddl {

/// The ids of one kind of names (types, objects, …), by lower case. However many they are, they
/// are soon freed.
class NameTable {
 public:
  /// `kind` in the singular, for messages.
  explicit NameTable(std::string kind) : kind_(std::move(kind)) {}

  const std::string& kind() const { return kind_; }
  /// False where the name is there already.
  bool add(std::string_view spelling, int id);
  std::optional<int> find(std::string_view spelling) const;
  /// The same for a name that is known to be in lower case: others are not found.
  std::optional<int> findLower(std::string_view name) const;
  /// Throws SemanticError for a name that was never declared.
  int at(const ast::Name& name, const std::string& source_name) const;

  /// `unknown object 'b'; did you mean 'b1'?`
  std::string unknown(std::string_view spelling) const;

 private:
  struct Entry {
    std::size_t begin = 0;
    std::size_t size = 0;
    int id = 0;
  };

  std::string_view nameOf(const Entry& entry) const {
    return std::string_view(text_).substr(entry.begin, entry.size);
  }

  std::string kind_;
  std::string text_;  // all names in a row
  std::vector<Entry> entries_;
  IdTable table_;  // of the entries
};

}  // namespace goal_alignment::pddl
