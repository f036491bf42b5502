// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "goal_alignment/pddl/ast.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/name_table.h"

/// Linking in four steps, each of which needs the ones before it: declarations, action schemas,
/// then the problem's facts and goal. Every step throws SemanticError at the first fault.
namespace goal_alignment::pddl {

/// What the steps hand on.
struct LinkContext {
  LinkContext(const ast::Domain& domain_ast, const ast::Problem& problem_ast, const Limits& limits);

  const ast::Domain& domain;
  const ast::Problem& problem;
  LimitMonitor monitor;
  bool domain_alone = false;  ///< an object that it does not declare may be any problem's
  Model model;
  NameTable types{"type"};
  NameTable objects{"object"};
  NameTable predicates{"predicate"};
  NameTable functions{"function"};
  NameTable schemas{"action"};

  /// At every object and fact; throws LimitReached.
  void pollLimits();

  /// The declared type, or `object` where none was written. A union enters the model's types.
  TypeId typeOf(const ast::TypedName& typed, const std::string& source_name);
  TypeId typeNamed(const ast::Name& name, const std::string& source_name) const;
};

/// Predicates or functions with their names: the two kinds of things that take arguments.
struct Vocabulary {
  const NameTable& names;
  const std::vector<Predicate>& signatures;
};
Vocabulary predicatesOf(const LinkContext& context);
Vocabulary functionsOf(const LinkContext& context);

void linkTypes(LinkContext& context);
/// The type of `(either a b)`: a known one where only one remains after subtypes are left out.
TypeId unionOf(LinkContext& context, const ast::TypeName& written, const std::string& source_name);
void linkObjects(LinkContext& context);
void linkPredicatesAndFunctions(LinkContext& context);
void linkSchemas(LinkContext& context);
void linkInit(LinkContext& context);
void linkGoal(LinkContext& context);

/// The id of the atom's predicate or function, known and given as many terms as it takes.
PredicateId signatureOf(const ast::Atom& atom, const Vocabulary& vocabulary,
                        const std::string& source_name);

/// The ground atom, with arguments of the right types.
Atom linkGroundAtom(const LinkContext& context, const ast::Atom& atom, const Vocabulary& vocabulary,
                    const std::string& source_name);

/// `'on' takes 2 arguments, found 1`
std::string wrongCount(const std::string& taker, std::size_t takes, std::size_t given);
/// `'b' is of type 'ball', but 'on' takes 'block' there`
std::string wrongType(const Model& model, std::string_view term, TypeId is,
                      const std::string& taker, TypeId wanted);

}  // namespace goal_alignment::pddl
