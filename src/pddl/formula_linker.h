// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "link_context.h"

namespace goal_alignment::pddl {

/// Names to ids in one action or one goal: knows which variables stand for objects where, and what
/// type each has.
class FormulaLinker {
 public:
  /// `here` ends the messages: ` in action 'go'`. Both references must outlive the linker.
  FormulaLinker(LinkContext& context, const std::string& source_name, std::string here)
      : context_(context), source_name_(source_name), here_(std::move(here)) {}

  /// Makes the names known until leave(); they hide others of the same name. Returns their indices.
  std::vector<int> enter(const std::vector<ast::TypedName>& variables);
  void leave();

  /// All variables that were ever entered, by index.
  const std::vector<Parameter>& variables() const { return variables_; }

  LiftedAtom atom(const ast::Atom& atom, const Vocabulary& vocabulary) const;
  Equality equality(const ast::Literal& literal) const;
  /// In negation normal form. Recursion is as deep as the text nests.
  Formula formula(const ast::Formula& written, bool negated = false);
  Formula conjunction(const ast::Condition& written);

  [[noreturn]] void fail(const ast::Name& at, const std::string& message) const;
  const std::string& here() const { return here_; }

 private:
  /// What a name meant outside, to be restored.
  struct Hidden {
    std::string name;
    std::optional<int> index;
  };

  Term term(const ast::Name& name) const;
  void checkType(const ast::Name& name, const Term& term, const Predicate& signature,
                 TypeId wanted) const;
  Formula literal(const ast::Literal& written, bool negated) const;
  Formula quantified(const ast::Formula& written, bool negated);

  LinkContext& context_;
  const std::string& source_name_;
  std::string here_;
  std::vector<Parameter> variables_;
  std::unordered_map<std::string, int> indices_;  // of the names that stand for something here
  std::vector<std::vector<Hidden>> scopes_;
};

}  // namespace goal_alignment::pddl
