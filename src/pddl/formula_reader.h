// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "goal_alignment/pddl/ast.h"
#include "token_reader.h"

/// Readers of atoms, conditions and terms, shared by domains, problems and lists of literals.
namespace goal_alignment::pddl {

/// Whether parameters may stand beside objects: in actions only.
enum class Terms { ObjectsOnly, WithParameters };

/// The words of PDDL's formulas, which can't name a predicate: `and`, `when`, `increase`, …
bool isReserved(std::string_view lower_case);

/// Throws UnsupportedError at `and`-like words that we read but don't treat (`or`, `when`, …), and
/// SyntaxError at the other reserved words, of which none may stand here.
void refuseReserved(const TokenReader& reader);

/// Zero or more terms, up to the `)`, which it leaves.
std::vector<ast::Name> readTerms(TokenReader& reader, Terms terms);

/// `name term …` up to the `)`, which it leaves; `what` names what is expected, for messages.
ast::Atom readAtom(TokenReader& reader, Terms terms, const std::string& what);

/// A literal or a conjunction, flattened; `()` and `(and)` are true.
ast::Condition readCondition(TokenReader& reader, Terms terms);

}  // namespace goal_alignment::pddl
