// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "goal_alignment/pddl/ast.h"
#include "token_reader.h"

/// Readers of what domains and problems declare, and of the frame both share.
namespace goal_alignment::pddl {

/// `(define (kind name)`, with kind `domain` or `problem`.
ast::Name readHeader(TokenReader& reader, const std::string& kind);

/// `:word …` up to the `)`, which it leaves. Flags promise nothing: what counts is what is used.
std::vector<ast::Name> readRequirements(TokenReader& reader);

/// `a b - type c …` up to the `)`, which it leaves; `what` is one element, for messages.
enum class ListOf { Types, Names, Variables };
std::vector<ast::TypedName> readTypedList(TokenReader& reader, ListOf kind,
                                          const std::string& what);

/// `(name ?x - type …) …` up to the `)`, which it leaves.
std::vector<ast::Predicate> readPredicates(TokenReader& reader);
std::vector<ast::Predicate> readFunctions(TokenReader& reader);

/// Which sections a text has had, to refuse a second one.
class SectionLog {
 public:
  /// The current token opens a section; throws SyntaxError where there was one such already.
  void note(const TokenReader& reader);

 private:
  std::map<std::string, SourcePosition> seen_;
};

/// The names of sections that one kind of text has.
struct Sections {
  std::vector<std::string> known;
  std::string expected;  ///< for messages
};

/// At the name of a section. Known to others but not to us, or known to nobody: throws
/// UnsupportedError or SyntaxError.
void expectSection(const TokenReader& reader, const Sections& sections);

}  // namespace goal_alignment::pddl
