// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "goal_alignment/pddl/ast.h"
#include "token_reader.h"

/// Readers of atoms, conditions and terms, shared by domains, problems and lists of literals.
namespace goal_alignment::pddl {

/// Whether variables may stand beside objects: in actions, and below quantifiers.
enum class Terms { ObjectsOnly, WithParameters };

/// The words of PDDL's formulas, which can't name a predicate: `and`, `when`, `increase`, …
bool isReserved(std::string_view lower_case);

/// Throws UnsupportedError at words of PDDL that we know but don't treat (`preference`, `>=`, …),
/// and SyntaxError at the other reserved words, of which none may stand here.
void refuseReserved(const TokenReader& reader);

/// `(?x ?y - type …)`: what a quantifier ranges over.
std::vector<ast::TypedName> readVariables(TokenReader& reader);

/// Zero or more terms, up to the `)`, which it leaves.
ast::Names readTerms(TokenReader& reader, Terms terms);

/// `name term …` up to the `)`, which it leaves; `what` names what is expected, for messages.
ast::Atom readAtom(TokenReader& reader, Terms terms, const std::string& what);

/// Any formula, the conjunctions in it flattened; `()` and `(and)` are true.
ast::Condition readCondition(TokenReader& reader, Terms terms);

}  // namespace goal_alignment::pddl
